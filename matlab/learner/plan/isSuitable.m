function yes = isSuitable(place, arms, eye, others, site)
% Returns true if a block at a place blocks nothing of a site, blocks existing or planned, and no grasp of others, but of
% those below it, is seen, and can be taken again.
  around = others(~standsOn(place, others));
  yes = ~(isGraspBlocked(place, site) || isTopHidden(place, site, eye) || ~canReach(arms, place) || ...
          blocksGrasps(place, around));
end

function yes = blocksGrasps(place, others)
% Returns true if a block at a place would leave no room for the fingers at one of the others that can be
% grasped without it.
  yes = false;
  for i = find(arrayfun(@(it) isClose(it, place), others))
    rest = others([1:i - 1, i + 1:end]);
    yes = ~isempty(graspYaws(others(i), rest)) && isempty(graspYaws(others(i), [rest, place]));
    if yes, return; end
  end
end
