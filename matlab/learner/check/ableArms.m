function [able, reason] = ableArms(arms, block, width, failures, fallback, name)
% Returns the arms that can hold a block across a width [units], and for which it is not known to be too heavy; and the reason to
% report if none of them can bring it to its place.
%   failures  see newGrasp; [] for none
%   fallback  the reason where no other is known
%   name      of the block in the reason; "it" if omitted
  if nargin < 6, name = 'it'; end
  reason = fallback;
  able = arms(arrayfun(@(arm) canHold(arm, width), arms));
  if isempty(able)
    reason = [name, ' is wider than the gripper opens'];
    return
  end
  is_weak = arrayfun(@(arm) isTooHeavy(block, arm, failures), able);
  if all(is_weak)
    reason = [name, ' is too heavy to be lifted'];
  elseif any(is_weak)
    reason = sprintf('%s is too heavy for the arm %s, and no other one can do it', name, able(find(is_weak, 1)).name);
  end
  able = able(~is_weak);
end
