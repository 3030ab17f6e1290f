function cost = siteCost(steps, known, eye)
% Returns the cost of a site: the lengths of the blocks that are in the way there or would be blocked by the
% building; a part of those of needed blocks that it would hide; and those of blocks on others that may be
% needed and were never seen, if it would hide them.
  cost = 0;
  share = constants().building_site.hidden_cost;
  for block = known
    if isGraspBlocked(block, steps)
      cost = cost + block.size(1);
    elseif any(arrayfun(@(step) isSameKind(block, step), steps)) && isTopHidden(block, steps, eye)
      cost = cost + share * block.size(1);
    end
    below = assumedSupport(block);
    if ~isempty(below) && isTopHidden(below, steps, eye), cost = cost + block.size(1); end
  end
end
