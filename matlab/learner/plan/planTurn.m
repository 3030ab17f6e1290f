function [actions, place, reason] = planTurn(arms, eye, block, held, then, others, sites, sensor, failures, unexplained)
% Plans the actions that turn a block onto another face, by 90 degrees about the axis on which the fingers hold it, and put
% it at a free place on the table. Returns them and the block at that place; {} and a reason if there is none.
%   held  the side by which it is held, as in turnedSize
%   then  by which one it must be held for the next turn there; [] for none
%   others, sites, failures, unexplained  as in planTemporaryPlacement
% The tool comes down over an edge of the block, half way between the face that is its top and the one that will be: so
% the hand is above the table before and after the turn.
  c = constants();
  actions = {};
  place = noBlocks();
  [able, reason] = ableArms(arms, block, block.size(held), failures, '');
  if isempty(able), return; end
  is_known = ~isempty(reason);
  if ~is_known, reason = 'no arm can hold it so that it can be turned'; end
  grasps = {};
  % Close to the limits of its joints, the hand of an arm may be folded to it: only if necessary.
  for margin = [c.motion_planning.tilted_limit_rad, 0]
    for arm = nearestFirst(able, block.position(1)), grasps = [grasps, tiltedGrasps(arm, block, held, others, margin)]; end
  end
  grasps = grasps(~cellfun(@(grasp) hasFailed(grasp.attempt, failures), grasps));
  if isempty(grasps), return; end

  if ~is_known, reason = 'there is no free place on the table where an arm can turn it'; end
  like = block;
  like.size = turnedSize(block.size, held);
  for site = sites
    num_tried = 0;
    for place = freePlacements(arms, eye, like, [others, site{1}], [], unexplained)
      if isempty(then), is_useful = canReach(arms, place); else, is_useful = canTurn(arms, place, then, others); end
      if ~is_useful, continue; end
      num_tried = num_tried + 1;
      if num_tried > c.task_planning.max_place_attempts, break; end
      for k = 1:numel(grasps)
        actions = planTurnTo(grasps{k}, block, held, place, others, sensor);
        if ~isempty(actions), return; end
      end
    end
  end
end
