% Runs the learner in Octave for the inputs of decisions_test.py; prints a result on each line.
% octave-cli decisions.m ROBOT CASE..., with matlab/learner, matlab/motion and smilemotion on the path.
1;
addpath(genpath(fileparts(which('agentBehavior'))));  % with the folders of its parts

function show(word, numbers)
  printf('%s%s\n', word, sprintf(' %.9f', double(numbers)));
end

function showAction(action)
  to = 0;
  width = 0;
  if isfield(action, 'to'), to = action.to; end
  if isfield(action, 'width'), width = action.width; end
  name = '';
  if isfield(action, 'arm'), name = [' ', action.arm.name]; end
  show(['action ', action.kind, name], [to, width]);
  if any(strcmp(action.kind, {'follow', 'lift', 'press'}))
    tool = smileForward(action.arm.robot, action.arm.name, action.path.positions(end, :));
    show('tool', [tool(1:3, 4)', tool(1:3, 2)']);
  end
end

function decideOn(folder, aux)
  printf('case %s\n', folder);
  shown = fullfile(folder, 'shown');
  if exist(fullfile(shown, '0.txt'), 'file'), demo = readDemonstration(shown); else, demo = watchDemonstration(shown); end
  [steps, containers, appearances] = inferTask(demo, struct('object', {}, 'properties', {}));
  [keyframes, goal] = explain(demo, appearances, containers);
  for keyframe = keyframes
    printf('deed %s %d\n', keyframe.deed, keyframe.isMeans);
    printf('fact %s\n', keyframe.facts{:});
  end
  printf('goal %s\n', goal{:});
  printPage(keyframes, goal);
  for step = steps
    if ~isempty(step.aside)
      [row, column] = find(step.aside.changed);
      show('aside', [step.aside.place.position, step.aside.place.yaw, step.aside.height, numel(row), sum(row - 1), ...
                     sum(column - 1)]);
    end
    show(['step ', step.name, ' ', step.form], [step.color, step.size, step.position, step.yaw, step.on - 1, ...
                                              step.hasKnob, step.beginsThere, step.after - 1]);
    show(strtrim(['begin ', step.takesPlaceOf]), [step.start, step.startSize]);
    for part = step.parts, show('part', [part.color, part.size, part.position, part.yaw]); end
  end
  presses = inferDevices(demo, steps, appearances);
  for press = presses
    [row, column] = find(press.changed);
    turns = [];
    for it = press.turns, turns = [turns, it.place, it.number, it.isLoosening]; end
    show(describePress(press), [press.after - 1, numel(row), sum(row - 1), sum(column - 1), press.pose, press.begin, ...
                                press.height, turns]);
  end
  state = initialTaskState(steps, containers, presses, demo.eye);
  sensor.rgbVision = double(imread(fullfile(folder, 'look.png'))) / 255;
  file = fopen(fullfile(folder, 'look.depth'));
  sensor.depthVision = fread(file, [size(sensor.rgbVision, 2), Inf], 'double')';
  fclose(file);
  eye = eyeOf(shown);
  eye.table = [20, 12];
  aux.cameraIntrinsics = eye.intrinsics;
  aux.cameraPose = eye.pose;
  aux.tableSize = eye.table;
  aux.cameraNames = {};
  arms = armsOf(aux);
  for arm = arms
    show(['arm ', arm.name], [arm.parked, arm.reach, arm.foot]);
    sensor.arms(arm.index).joints = arm.parked;
  end
  % Where something may swing, it looks again and again until it hangs still.
  actions = {};
  while ~state.hasSite && isempty(state.claim)
    [actions, state] = chooseActions(state, sensor, eye, armsFor(steps, arms));
  end
  known = zeros(0, 10);
  for it = state.known
    known(end + 1, :) = [it.position, it.color, it.size, it.yaw];
  end
  [~, order] = sortrows(round(known(:, 1:3) * 1e4));
  for k = order'
    show('known', known(k, :));
  end
  show('unexplained', [rows(state.unexplained), sum(state.unexplained, 1)]);
  for step = state.steps
    show('site', [step.position, step.yaw]);
  end
  for it = state.alignments, show(['aligned ', it.control], [cos(it.angle), sin(it.angle), it.place]); end
  for it = state.notes, printf('note %s: %s\n', it.word, it.text); end
  if ~isempty(state.claim), printf('claim %s\n', state.claim.reason); end
  for k = 1:numel(actions)
    showAction(actions{k});
  end
end

files = argv();
aux = jsondecode(fileread(files{1}));
for k = 2:numel(files)
  decideOn(files{k}, aux);
end
