function check_presses()
% A switch is pressed: its raised side changes, and a lamp goes on.
  eye = robotEye();
  [folder, remove] = newRecording({pictureOf(fixture(0, -2, 0, false)), pictureOf(fixture(0, -2, 0, true))});
  write(folder, '0.txt', {'0,create,Panel,shape,composite', '0,move,Panel,0.0,-2.0,0.1,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,trigger,LeftHand,Switch'});
  press = inferDevices(readDemonstration(folder), noSteps(), noBlocks());
  check(numel(press) == 1 && strcmp(describePress(press), 'press of Switch') && isempty(press.after), 'a press is inferred');

  [picture, heights] = pictureOf(fixture(1.5, -3, 0.4, false));
  alignment = locateControl(press, picture, heights, eye, eye);
  check(abs(sin((alignment.angle + 0.4) / 2)) < 0.01, 'the fixture is found turned');
  check(norm(alignedPoints(alignment, [1.5, -3, 0])(1:2) - [0, -2]) < 0.03, 'at its place');
  surface = surfaceOf(picture, heights, eye);
  check(~looksPressed(press, alignment, surface, eye), 'its switch is not pressed');
  button = buttonOf(press, alignment, surface, eye);
  check(norm(button.position(1:2) - [1.5, -3] - rotated([0.3, -0.4], 0.4)) < 0.14, 'the raised side is the button');
  check(abs(blockTops(button) - 0.45) < 0.01, 'at its height');
  check(abs(sin(button.yaw - 0.4)) < 0.1, 'fingers lie along its hinge');
  [picture, heights] = pictureOf(fixture(1.5, -3, 0.4, true));
  check(looksPressed(press, alignment, surfaceOf(picture, heights, eye), eye), 'another look shows that it was pressed');
  check_two_presses(eye);
  check_stop();
  check_lamp_elsewhere(press);

  state = knowColors(initialTaskState(noSteps(), [], press, eye), picture, eye, heights, segmentTopFaces(picture, tableColor(picture), heights));
  check(isequal(state.presses.before, press.before), 'in the same light nothing changes');
  [picture, heights] = pictureOf(fixture(1.5, -3, 0.4, false));
  light = [0.8, 0.75, 0.6];
  picture = round(255 * picture .* reshape(light, 1, 1, 3)) / 255;
  check(isempty(locateControl(press, picture, heights, eye, eye)), 'in another light it looks otherwise');
  step = newStep(block([0, 1, 0], [1, 1, 1], 0, 0, 0, 0), 'cube');
  state = knowColors(initialTaskState(step, [], press, eye), picture, eye, heights, segmentTopFaces(picture, tableColor(picture), heights));
  check(max(abs(state.steps.color - light .* [0, 1, 0])) < 0.005, 'so does what is wanted');
  alignment = locateControl(state.presses, picture, heights, eye, eye);
  check(abs(sin((alignment.angle + 0.4) / 2)) < 0.01, 'and is found as the demonstration would look there');
  check(~looksPressed(state.presses, alignment, surfaceOf(picture, heights, eye), eye), 'and judged');

  others = [block([0.5, 0.5, 0.5], [1, 0.5, 0.3], 1, -3, 0, 0), block([1, 0, 0], [1, 2, 1.6], -2, -3, 0, 0)];
  [picture, heights] = pictureOf(others);
  check(isempty(locateControl(press, picture, heights, eye, eye)), 'what is not there is not found');

  [nothing, flat] = pictureOf(noBlocks());
  state = observe(observe(initialTaskState(noSteps(), [], press, eye), nothing, flat, eye), nothing, flat, eye);
  check(isempty(state.known), 'an empty table may be looked at');
  state = initialTaskState(noSteps(), [], press, eye);
  [state, problem] = locateControls(state, picture, heights, eye);
  check(strcmp(problem, 'the surroundings of Switch are not visible'), 'and reported');
  for k = 1:constants().perception.num_still
    [is_moving, state] = isMoving(state, picture);
    check(is_moving, 'something may still move');
  end
  [is_moving, state] = isMoving(state, picture);
  check(~is_moving, 'until it looks the same several times');
end

function check_lamp_elsewhere(press)
% The switch also drives a lamp on another object.
  gray = block([0.5, 0.5, 0.5], [0.8, 0.8, 1.5], 4, -1, 0, 0);
  green = block([0, 1, 0], [0.8, 0.8, 1.5], 4, -1, 0, 0);
  [folder, remove] = newRecording({pictureOf([fixture(0, -2, 0, false), gray]), pictureOf([fixture(0, -2, 0, true), green])});
  write(folder, '0.txt', {'0,create,Panel,shape,composite', '0,create,Post,shape,composite', ...
                          '0,initializeControl,Switch,toggleSwitch,Panel,0', '0,initializeControl,Lamp,indicatorLights,Post,off', ...
                          '0,move,Panel,0.0,-2.0,0.1,0.0,0.0,0.0', '0,move,Post,4.0,-1.0,0.75,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,trigger,LeftHand,Switch'});
  demo = readDemonstration(folder);
  [steps, containers] = inferTask(demo, []);
  check(isempty(steps) && isempty(containers), 'a task may be to press something, and nothing else');
  found = inferDevices(demo, noSteps(), noBlocks());
  check(isequal(found.changed, press.changed), 'the button is on the object of the control, and no lamp elsewhere');
end

function check_two_presses(eye)
% A switch is pressed twice: the first time, both lamps go off, and the second time, one goes on.
  picture = @(varargin) pictureOf(fixture(0, -2, 0, varargin{:}));
  [folder, remove] = newRecording({picture(true, true), picture(false), picture(true)});
  write(folder, '0.txt', {'0,create,Panel,shape,composite', '0,move,Panel,0.0,-2.0,0.1,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,trigger,LeftHand,Switch'});
  write(folder, '2.txt', {'2,trigger,LeftHand,Switch'});
  press = inferDevices(readDemonstration(folder), noSteps(), noBlocks())(2);
  [picture, heights] = pictureOf(fixture(1.5, -3, 0.4, false));
  alignment = locateControl(press, picture, heights, eye, eye);
  for is_failing = [true, false]
    [picture, heights] = pictureOf(fixture(1.5, -3, 0.4, true, is_failing));
    yes = looksPressed(press, alignment, surfaceOf(picture, heights, eye), eye);
    check(yes == ~is_failing, 'a lamp that an earlier press switched off is to be off');
  end
end

function check_stop()
% An arm of one joint presses what is at 0.5 rad, on a path of a second to 1 rad, also with half the speed.
  eval('function q = smileSample(~, seconds), q = min(max(seconds(:), 0), 1); end');
  remove = onCleanup(@() clear('-f', 'smileSample'));
  path = struct('positions', [0; 1], 'duration', 1);
  aux = struct('tickSeconds', 1 / 60, 'maxTicks', 30, 'arms', struct('joints', {{'j1'}}));
  for speed = [1, 0.5]
    aux.variationSpeed = speed;
    action = struct('kind', 'press', 'arm', struct('index', 1), 'path', path);
    q = 0;
    status = 'busy';
    num_ticks = 0;
    while strcmp(status, 'busy') && num_ticks < 240
      sensor = struct('arms', struct('joints', q), 'timeElapsed', aux.tickSeconds);
      [action, motor, status] = executeAction(action, sensor, aux);
      wanted = q + motor.arms.velocities * aux.tickSeconds;
      check(motor.ticks == 1 && wanted < 0.56, 'a press does not push on');
      q = min(wanted, 0.5);
      num_ticks = num_ticks + 1;
    end
    check(strcmp(status, 'done') && abs(q) < 0.001, 'but goes back');
    check(abs(num_ticks * aux.tickSeconds - 1 / speed) < 0.1 / speed, 'as soon as something stops the arm');
    action.time = aux.tickSeconds;
    [~, velocities] = followPath(action, sensor, aux);
    check(all(abs(velocities(2:end) - speed) < 1e-9), 'a path is followed with the speed that is asked for');
  end
end

function blocks = fixture(x, y, yaw, is_on, is_failing)
% Returns a panel with a switch on it, and lamps, if they are on.
  if nargin < 5, is_failing = false; end
  at = @(dx, dy) [x, y] + rotated([dx, dy], yaw);
  part = @(color, size, at, bottom) block(color, size, at(1), at(2), bottom, yaw);
  gray = [0.5, 0.5, 0.5];
  blocks = [part([0.5, 0.3, 0.2], [3, 2.4, 0.2], [x, y], 0), part([0, 0, 1], [0.4, 1.6, 0.3], at(1.2, 0), 0.2)];
  if is_on, blocks = [blocks, part([0, 1, 0], [0.3, 0.3, 0.05], at(-0.3, 0.5), 0.2)]; end
  if is_failing, blocks = [blocks, part([1, 0, 0], [0.3, 0.3, 0.05], at(0.3, 0.5), 0.2)]; end
  side = 0.3;
  if is_on, side = -0.3; end
  blocks = [blocks, part(gray, [1, 0.5, 0.1], at(0, -0.4), 0.2), part(gray, [0.4, 0.5, 0.15], at(side, -0.4), 0.3)];
end
