function [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, goal, failures, ...
                                                           left, unexplained)
% Plans the actions that bring a block to a free place on the table or on another block, within the eye's view. Returns them
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
  tried = noBlocks();
  for k = 1:numel(sites) + 1
    % First those on the table, at last those on others.
    if k <= numel(sites)
      site = sites{k};
      places = freePlacements(arms, eye, block, [others, site], goal, unexplained);
    else
      site = sites{1};
      places = placesOnOthers(block, others, site, eye);
    end
    num_tried = 0;
    for place = places
      has_yaw = tried([tried.yaw] == place.yaw);
      if isNear(place, left) || isNear(place, has_yaw), continue; end
      if ~isSuitable(place, arms, eye, others, site), continue; end
      [actions, reason] = planToPlace(arms, block, place, others, sensor, goal, failures);
      if ~isempty(actions), return; end
      tried(end + 1) = place;
      num_tried = num_tried + 1;
      if num_tried == constants().task_planning.max_place_attempts, break; end
    end
  end
end
