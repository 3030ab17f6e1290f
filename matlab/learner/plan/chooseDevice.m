function [actions, state, problem] = chooseDevice(state, arms, picture, heights, eye, sensor)
% Plans the next press of a button or use of a tool, if its time has come: a 1xN cell of actions; {} if there is none. A
% problem says if one must be done and cannot be.
  actions = {};
  problem = '';
  surface = surfaceOf(picture, heights, eye);
  for k = find(~[state.presses.done])
    press = state.presses(k);
    if ~all(state.done(press.after)), return; end
    alignment = alignmentOf(press, state);
    is_drive = ~isempty(press.turns);
    if (is_drive && wasDriven(press, state)) || (~is_drive && looksPressed(press, alignment, surface, state.shown))
      state.presses(k).done = true;
      continue
    end
    if press.attempts >= constants().presses.max_attempts
      problem = sprintf('%s: %d attempts failed', describePress(press), press.attempts);
      return
    end
    if isempty(press.tool)
      [actions, state.grasp, problem] = planPress(press, alignment, surface, state, arms, sensor);
    elseif is_drive
      [actions, state, problem] = planDrive(press, alignment, surface, state, arms, sensor);
      state.presses(k).grasp = state.grasp;
    else
      [actions, state, problem] = planUse(press, alignment, surface, state, arms, sensor);
    end
    state.presses(k).attempts = press.attempts + 1;
    if ~isempty(problem), problem = [describePress(press), ': ', problem]; end
    return
  end
end
