function [able, why] = ableArms(arms, block, width, failures, fallback)
% Returns the arms that can hold a block across a width [units], and for which it is not known to be too heavy; and why they cannot
% bring it somewhere.
%   fallback  the reason where no other is known
  why = fallback;
  able = arms(arrayfun(@(arm) canHold(arm, width), arms));
  if isempty(able)
    why = 'it is wider than the gripper opens';
    return
  end
  is_weak = arrayfun(@(arm) isTooHeavy(block, arm, failures), able);
  if all(is_weak)
    why = 'it is too heavy to be lifted';
  elseif any(is_weak)
    why = sprintf('it is too heavy for the arm %s, and no other one can do it', able(find(is_weak, 1)).name);
  end
  able = able(~is_weak);
end
