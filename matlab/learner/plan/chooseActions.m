function [actions, state] = chooseActions(state, sensor, eye, arms)
% Updates the beliefs from a picture and plans the next actions: a 1xN cell; {} when everything is built
% or no plan is found (state.claim says which).
  actions = {};
  picture = sensor.rgbVision;
  if ~isempty(state.presses) && ~state.hasSite
    [is_moving, state] = isMoving(state, picture);
    if is_moving
      actions = {struct('kind', 'observe')};
      return
    end
  end
  heights = heightMap(sensor.depthVision, eye);
  state = observe(state, picture, heights, eye);
  if numel(sensor.arms) == 1, state = forgetArm(state, arms, sensor); end
  state.surface = [];
  has_asides = ~all(cellfun(@isempty, {state.steps.aside}));
  if has_asides, state.surface = surfaceOf(picture, heights, eye); end
  if ~state.hasSite
    [state, problem] = locateControls(state, picture, heights, eye);
    if isempty(problem), [state, problem] = locateAsides(state, picture, heights, eye); end
    if isempty(problem), [state, problem] = chooseSite(state, arms, picture, eye); end
    if ~isempty(problem)
      state = giveUp(state, ['before it began: ', problem]);
      return
    end
    state.notes = [state.notes, planNotes(state.steps)];
  end

  if ~isempty(state.presses), state = forgetFixtures(state, picture, heights, eye); end
  [state, used] = assessProgress(state);
  if ~isempty(state.presses)
    [actions, state, problem] = chooseDevice(state, arms, picture, heights, eye, sensor);
    if ~isempty(problem), state = giveUp(state, ['at the ', problem]); end
    if ~isempty(actions) || ~isempty(problem), return; end
  end
  open = openSteps(state);
  if isempty(open) && ~isempty(state.unclear)
    state = giveUp(state, ['not understood in the demonstration: ', strjoin(state.unclear, ', ')]);
    return
  elseif isempty(open)
    reason = sprintf('as seen within %.2f units and %.1f degrees', ...
                     max([state.placementErrors; 0, 0], [], 1) .* [1, 180 / pi]);
    state.claim = struct('done', true, 'reason', reason);
    return
  end
  [actions, state] = planOneOf(open, state, find(~used & ~areDrivers(state)), eye, arms, sensor);
end

function yes = areDrivers(state)
% Returns which known blocks are tools that drive, which stay in their holders meanwhile.
  drives = state.presses(~cellfun(@isempty, {state.presses.turns}));
  yes = arrayfun(@(it) any(arrayfun(@(drive) isSameKind(it, drive.tool), drives)), state.known);
end
