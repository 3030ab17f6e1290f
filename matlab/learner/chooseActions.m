function [actions, state] = chooseActions(state, sensor, eye, arms)
% Updates the beliefs from a picture and plans the next actions: a 1xN cell; {} when everything is built
% or no plan is found (state.claim says which).
  c = constants().task_planning;
  actions = {};
  picture = sensor.rgbVision;
  heights = heightMap(sensor.depthVision, eye);
  state = observe(state, picture, heights, eye);
  if ~state.hasSite
    [state, problem] = chooseSite(state, arms, picture, eye);
    if ~state.hasSite
      state = giveUp(state, ['before it began: ', problem]);
      return
    end
    state.notes = [state.notes, planNotes(state.steps)];
  end

  [state, used] = assessProgress(state);
  open = openSteps(state);
  if isempty(open)
    reason = sprintf('as seen within %.2f units and %.1f degrees', ...
                     max(state.placementErrors, [], 1) .* [1, 180 / pi]);
    state.claim = struct('done', true, 'reason', reason);
    return
  end

  % The next step in the demonstrated order; while that is blocked, one of the other open steps.
  k = open(1 + mod(state.numBlocked, numel(open)));
  reason = 'no matching block is visible';
  if state.attempts(k) >= c.max_attempts
    reason = sprintf('%d attempts failed', c.max_attempts);
  elseif state.numTemporary >= c.max_temporary_placements
    reason = sprintf('blocks were put aside %d times already', c.max_temporary_placements);
  else
    free = find(~used);
    moves = [uncoveringMoves(state, free, eye), proposeMoves(state, k, free)];
    for move = [moves, clearingMoves(state, moves, free)]
      if numFailures(state, state.known(move.block)) >= c.max_failed_grasps
        reason = sprintf('%d grasps of a block failed', c.max_failed_grasps);
        continue
      end
      [actions, place, is_temporary, reason] = planMove(state, k, move, eye, arms, sensor);
      if isempty(actions), continue; end
      state.numTemporary = state.numTemporary + is_temporary;
      state.attempts(k) = state.attempts(k) + ~is_temporary;
      from = state.known(move.block);
      if is_temporary, state.left(end + 1) = from; end
      state.known(move.block) = [];
      state.known = [state.known, place];
      state.numBlocked = 0;
      grasp = actions{find(cellfun(@(it) strcmp(it.kind, 'grasp'), actions), 1)};
      state.grasp = grasp.grasp;
      if isempty(move.goal), state.moved = nameOf(place, state.steps); else, state.moved = move.goal.name; end
      state.notes(end + 1) = actionNote(state.moved, from, place, move.goal, is_temporary, grasp.arm);
      return
    end
  end
  if state.numBlocked == 0, state.firstFailure = [describeStep(state.steps(k)), ': ', reason]; end
  state.numBlocked = state.numBlocked + 1;
  if state.numBlocked > numel(open) + 1
    state = giveUp(state, ['at ', state.firstFailure]);
  else
    actions = {struct('kind', 'observe')};
  end
end

function state = observe(state, picture, heights, eye)
% Updates the known blocks from a picture.
  container = state.container;
  if ~state.hasSite, container = []; end  % its place in this scene is not known yet
  like = [asBlocks(state.steps), state.unknownObjects];
  seen = detectBlocks(picture, eye, like, container, heights);
  if ~state.hasSite || state.numBlocked > 0
    unknown = detectUnknownObjects(picture, eye, [seen, state.known], heights);
    state.unknownObjects = [state.unknownObjects, unknown];
    seen = detectBlocks(picture, eye, [like, unknown], container, heights);
  end
  state = compare(state, seen, picture, eye, heights);
end

function state = compare(state, seen, picture, eye, heights)
% Compares what is expected, the known blocks, with those seen in a picture, and corrects it. If the block that
% was just moved is not where it should be, its grasp failed.
  tolerance = constants().blocks.position_tolerance;
  % What is dropped into a container may lie anywhere inside.
  if ~isempty(state.container), tolerance = constants().blocks.confined_tolerance; end
  verdicts = verdictsOn(state.known, seen, picture, eye, heights, tolerance);
  if isempty(state.known)
    state.notes(end + 1) = asNote('saw', sprintf('%d objects', numel(seen)), noBlocks(), seen);
  end
  state.notes = [state.notes, verdictNotes(verdicts, seen, state.steps, state.moved)];
  if ~isempty(state.moved) && strcmp(verdicts(end).word, 'contradicted')
    state.failures(end + 1) = state.grasp;
  end
  state.moved = '';
  state.known = corrected(seen, verdicts);
end

function count = numFailures(state, block)
% Returns the number of failed grasps of a block at its place.
  near = constants().motion_planning.same_place_distance;
  count = sum(arrayfun(@(grasp) norm(grasp.position - block.position) < near, state.failures));
end

function open = openSteps(state)
% Returns the numbers of the steps that are not done and whose supports are done, in demonstrated order.
  open = find(~state.done);
  open = open(arrayfun(@(k) all(state.done(state.steps(k).on)), open));
end

function [actions, place, is_temporary, reason] = planMove(state, k, move, eye, arms, sensor)
% Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise to a
% temporary place, if necessary where a later step will be.
%   k             number of the current step
%   place         the block where it will be
%   is_temporary  whether that is a temporary place
  block = state.known(move.block);
  others = [state.known([1:move.block - 1, move.block + 1:end]), assumedSupport(block), ...
            containerWalls(state.container)];
  steps = state.steps;
  container = asBlocks(state.container);
  sites = {[asBlocks(steps), container]};
  is_temporary = false;
  if ~isempty(move.goal)
    sites{2} = [asBlocks(steps(state.done)), container];
    [actions, reason] = planPickAndPlace(arms, block, move.goal, others, sensor, state.failures);
    place = block;
    place.position = move.goal.position;
    place.yaw = move.goal.yaw;
    if ~isempty(actions), return; end
  elseif any(overlap(gripperClearance(steps(k)), footprint(block, 0)))
    sites{2} = [asBlocks(steps([find(state.done), k])), container];
  end
  is_temporary = true;
  left = noBlocks();
  if isempty(move.goal)
    left = [state.left, block];
    left = left(arrayfun(@(it) isSameKind(block, it), left));
  end
  [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, move.goal, ...
                                                    state.failures, left);
end
