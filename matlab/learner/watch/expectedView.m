function view = expectedView(blocks, shape, eye)
% Returns what the eye would see of known blocks in a picture of a shape [height, width].
%   view.blocks, view.eye
%   view.owner  number of the block that each pixel would show, HxW; 0 for none
%   view.isTop  the pixels that would show tops, HxW logical
  view = struct('blocks', {blocks}, 'eye', eye, 'owner', zeros(shape), 'isTop', false(shape));
  % The farthest first: the nearer ones hide them.
  [~, far] = sort(arrayfun(@(it) -norm(it.position - eye.pose(1:3, 4)'), blocks));
  for k = far
    corners = toPixel(cornersOf(blocks(k)), eye);
    outline = filled(hull(corners), shape);
    view.owner(outline) = k;
    view.isTop(outline) = false;
    top = filled(corners(1:4, :), shape);
    view.owner(top) = k;
    view.isTop(top) = true;
  end
end
