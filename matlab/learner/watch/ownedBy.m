function mask = ownedBy(view, is_one)
% Returns the mask, HxW logical, of the pixels that would show one of some blocks of a view (see expectedView).
%   is_one  which of them, N logical
  mask = false(size(view.owner));
  if ~any(is_one), return; end
  is_one = [false; is_one(:)];
  mask = reshape(is_one(view.owner + 1), size(view.owner));
end
