function [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, goal, failures, ...
                                                           left, unexplained)
% Plans the actions that bring a block to a free place on the table, within the eye's view. Returns them
% and that place; {} and a reason if there is none.
%   others  obstacles, as blocks
%   sites   cell of lists of blocks to keep clear of, existing or planned; the first list that leaves a
%           place counts
%   goal    target to which an arm must be able to move it from there, or []
%   failures  grasps that are not to be repeated
%   left      places to which it does not return, as blocks
%   unexplained  as from unexplainedPoints
  actions = {};
  place = noBlocks();
  reason = 'there is no free place on the table';
  if ~canReach(arms, block)
    reason = 'no arm reaches it';
    return
  end
  for site = sites
    tried = noBlocks();
    for place = freePlacements(arms, eye, block, [others, site{1}], goal, unexplained)
      has_yaw = tried([tried.yaw] == place.yaw);
      if isNear(place, left) || isNear(place, has_yaw) || isGraspBlocked(place, site{1}) || ...
         isTopHidden(place, site{1}, eye) || blocksGrasps(place, others) || ~canReach(arms, place)
        continue
      end
      can_continue = isempty(goal) || ~isempty(planPickAndPlace(arms, place, goal, others, sensor, []));
      if can_continue, [actions, reason] = planPickAndPlace(arms, block, place, others, sensor, failures); end
      if ~isempty(actions), return; end
      tried(end + 1) = place;
      if numel(tried) == constants().task_planning.max_place_attempts, break; end
    end
  end
end

function yes = isNear(place, left)
% Returns true if a place is close to one of some others.
  near = constants().task_planning.near_place_distance;
  yes = any(arrayfun(@(it) norm(it.position - place.position) < near, left));
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
