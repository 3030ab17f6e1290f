function [actions, place, is_temporary, reason] = planMove(state, k, move, eye, arms, sensor)
% Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise to a
% temporary place, if necessary where a later step will be.
%   k             number of the current step
%   place         the block where it will be
%   is_temporary  whether that is a temporary place
%   actions       1xN cell; {} and a reason if there are none
  block = state.known(move.block);
  steps = state.steps;
  for step = steps(~cellfun(@isempty, {steps.aside}))
    if ~isSameKind(block, step), continue; end
    is_temporary = isempty(move.goal);
    [actions, place, reason] = planReturning(withDepth(block, state.surface), step, ~is_temporary, state, arms, sensor);
    return
  end
  others = withHeldParts(state.known([1:move.block - 1, move.block + 1:end]));
  others = [others, assumedSupport(block), containerWalls(state.containers)];
  containers = asBlocks(state.containers);
  sites = {[asBlocks(steps), containers]};
  is_temporary = false;
  goal = move.goal;
  if ~isempty(goal)
    % Where the fingers have no room in a container, it is released above the rim.
    around = containerAt(containers, goal.position);
    if ~isempty(around) && isempty(graspYaws(goal, others))
      goal.position(3) = around.position(3) + (around.size(3) + goal.size(3)) / 2;
    end
    sites{2} = [asBlocks(steps(state.done)), containers];
    [actions, reason] = planPickAndPlace(arms, withDepth(block, state.surface), withDepth(goal, state.surface), others, ...
                                         sensor, state.failures, wayOf(state.choices, sum(state.attempts) + state.numTemporary));
    place = block;
    place.position = move.goal.position;
    place.yaw = move.goal.yaw;
    if ~isempty(actions), return; end
  elseif ~isempty(move.turns)
    is_temporary = true;
    [actions, place, reason] = planTurn(arms, eye, block, move.turns(1), move.turns(2:min(2, end)), others, sites, ...
                                        sensor, state.failures, state.unexplained);
    return
  elseif any(overlap(gripperClearance(steps(k)), footprint(block, 0)))
    sites{2} = [asBlocks(steps([find(state.done), k])), containers];
  end
  is_temporary = true;
  left = state.left;
  if isempty(goal), left(end + 1) = block; end
  left = left(arrayfun(@(it) isSameKind(block, it), left));
  if ~isempty(move.room), sites = cellfun(@(site) [site, move.room], sites, 'UniformOutput', false); end
  [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, goal, ...
                                                    state.failures, left, state.unexplained);
end
