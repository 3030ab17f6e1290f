function cost = siteCost(steps, known, eye)
% Returns the cost of a site: the lengths of the blocks that are in the way there or would be blocked by the
% building; a part of those of needed blocks that it would hide; and those of blocks on others that may be
% needed and were never seen, if it would hide them.
  cost = 0;
  share = constants().building_site.hidden_cost;
  is_blocked = isGraspBlocked(known, steps);
  for k = 1:numel(known)
    block = known(k);
    if is_blocked(k)
      cost = cost + block.size(1);
    elseif isTopHidden(block, steps, eye) && any(arrayfun(@(step) isSameKind(block, step), steps))
      cost = cost + share * block.size(1);
    end
    below = assumedSupport(block);
    if ~isempty(below) && isTopHidden(below, steps, eye), cost = cost + block.size(1); end
  end
end
