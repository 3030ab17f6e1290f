function [actions, place, why, reason] = planMove(state, k, move, eye, arms, sensor)
% Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise to a
% temporary place, if necessary where a later step will be.
%   k        number of the current step
%   place    the block where it will be
%   why      there, if that is only a temporary place; empty for its goal
%   actions  1xN cell; {} and a reason if there are none
  block = state.known(move.block);
  steps = state.steps;
  for step = steps(~cellfun(@isempty, {steps.aside}))
    if ~isSameKind(block, step), continue; end
    why = '';
    if isempty(move.goal), why = 'out of the way'; end
    [actions, place, reason] = planReturning(withDepth(block, state.surface), step, isempty(why), state, arms, sensor);
    return
  end
  others = withHeldParts(state.known([1:move.block - 1, move.block + 1:end]));
  others = [others, assumedSupport(block), containerWalls(state.containers)];
  containers = asBlocks(state.containers);
  sites = {[asBlocks(steps), containers]};
  goal = move.goal;
  if ~isempty(goal)
    sites{2} = [asBlocks(steps(state.done)), containers];
    [actions, place, why, goal, reason] = planToGoal(state, block, goal, others, arms, sensor);
    if ~isempty(actions), return; end
  elseif ~isempty(move.turns)
    why = 'onto another face';
    [actions, place, reason] = planTurn(arms, eye, block, move.turns(1), move.turns(2:min(2, end)), others, sites, ...
                                        sensor, state.failures, state.unexplained);
    return
  elseif any(overlap(gripperClearance(steps(k)), footprint(block, 0)))
    sites{2} = [asBlocks(steps([find(state.done), k])), containers];
  end
  why = 'for the other arm';
  left = state.left;
  if isempty(goal)
    why = 'out of the way';
    left(end + 1) = block;
  end
  left = left(arrayfun(@(it) isSameKind(block, it), left));
  if ~isempty(move.room), sites = cellfun(@(site) [site, move.room], sites, 'UniformOutput', false); end
  [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, goal, ...
                                                    state.failures, left, state.unexplained);
end

function [actions, place, why, goal, reason] = planToGoal(state, block, goal, others, arms, sensor)
% Plans to bring a block to its goal, or, where what it touches there leaves no room for fingers, to push it there, or to bring it
% to where it can be pushed from.
%   place  the block where it will be
%   why    there, if that is not its goal, else ''
%   goal   to where an arm would have to bring it
  why = '';
  reason = '';
  place = block;
  place.position = goal.position;
  place.yaw = goal.yaw;
  if isempty(graspYaws(goal, others))
    container = containerAt(state.containers, goal.position);
    if isempty(container)
      [actions, starts] = pushesTo(arms, block, goal, others, sensor, state.failures);
      if ~isempty(actions), return; end
      if ~isempty(starts)
        why = 'to be pushed from there';
        goal = starts(1);
        place.position = goal.position;
        place.yaw = goal.yaw;
      end
    else
      % Where the fingers have no room in a container, it is released above the rim.
      goal.position(3) = container.position(3) + (container.size(3) + goal.size(3)) / 2;
    end
  end
  way = wayOf(state.choices, sum(state.attempts) + state.numTemporary);
  [actions, reason] = planPickAndPlace(arms, withDepth(block, state.surface), withDepth(goal, state.surface), others, ...
                                       sensor, state.failures, way);
end
