% Runs the learner in Octave for the inputs of decisions_test.py; prints a result on each line.
% octave-cli decisions.m URDF CASE..., with matlab/learner, matlab/motion and smilemotion on the path.
1;

function show(word, numbers)
  printf('%s%s\n', word, sprintf(' %.9f', double(numbers)));
end

function showAction(action, robot)
  to = 0;
  width = 0;
  arm = 1;
  if isfield(action, 'to'), to = action.to; end
  if isfield(action, 'width'), width = action.width; end
  if isfield(action, 'arm'), arm = action.arm; end
  show(['action ', action.kind], [arm - 1, to, width]);
  if strcmp(action.kind, 'follow')
    names = {'left', 'right'};
    tool = smileForward(robot, names{arm}, action.path.positions(end, :));
    show('tool', [tool(1:3, 4)', tool(1:3, 2)']);
  end
end

function decideOn(folder, robot)
  printf('case %s\n', folder);
  demo = readDemonstration(fullfile(folder, 'shown'));
  [steps, container] = inferTask(demo, struct('object', {}, 'properties', {}));
  for step = steps
    show(['step ', step.name], [step.color, step.size, step.position, step.yaw, step.on - 1]);
  end
  state = initialTaskState(steps, container);
  sensor.rgbVision = double(imread(fullfile(folder, 'look.png'))) / 255;
  sensor.jointAngles = [parkedAngles(1); parkedAngles(2)];
  [actions, state] = chooseActions(state, sensor, eyeOf(fullfile(folder, 'shown')), robot);
  known = zeros(0, 10);
  for it = state.known
    known(end + 1, :) = [it.position, it.color, it.size, it.yaw];
  end
  [~, order] = sortrows(round(known(:, 1:3) * 1e4));
  for k = order'
    show('known', known(k, :));
  end
  for step = state.steps
    show('site', [step.position, step.yaw]);
  end
  for k = 1:numel(actions)
    showAction(actions{k}, robot);
  end
end

% Pose of the robot at a table 12 units deep.
base = [0, -1, 0, 0; 1, 0, 0, -8; 0, 0, 1, 2; 0, 0, 0, 1];
files = argv();
robot = smileRobot(files{1}, base, 0.1);
for k = 2:numel(files)
  decideOn(files{k}, robot);
end
