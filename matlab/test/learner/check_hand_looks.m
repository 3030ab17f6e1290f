function check_hand_looks()
% A tower hides a green cube behind it: a hand looks there. No robot is here: each path is possible.
  red = [1, 0, 0]; green = [0, 1, 0]; cube = [1, 1, 1];
  eval('function path = planPathThrough(varargin), path = {1, 2}; end');
  eval('function pose = toolPose(varargin), pose = eye(4); end');
  eval('function heights = heightMap(depth, eye), heights = depth; end');
  remove = onCleanup(@() clear('-f', 'planPathThrough', 'toolPose', 'heightMap'));
  for k = 1:4, tower(k) = block(red, cube, 4, -2, k - 1, 0); end
  behind = block(green, cube, 4.6, -0.4, 0, 0);
  [~, heights] = pictureOf([behind, tower]);
  state = initialTaskState([asStep(block(green, cube, 0, -2, 0, 0)), asStep(block(red, cube, 2, -2, 0, 0))], []);
  state.known = tower;
  arm = struct('name', 'right', 'index', 1, 'camera', 'right_hand', 'reach', 0.7, 'foot', [2.6, -7]);
  sensor.depthVision = heights;
  sensor.arms = struct('joints', {0, 0});
  [actions, state] = planHandLook(1, state, [], robotEye(), arm, sensor);
  kinds = cellfun(@(it) it.kind, actions, 'UniformOutput', false);
  check(isequal(kinds, {'follow', 'look', 'follow', 'observe'}), 'a hand looks');
  check(norm(state.handLooks - behind.position(1:2)) < 1.5, 'behind what hides the table');
  [~, again] = planHandLook(1, state, [], robotEye(), arm, sensor);
  check(rows(again.handLooks) == 1 || norm(diff(again.handLooks)) >= 2, 'once at each place');
  stopped = rememberFailure(state, actions, 'an obstacle');
  check(numel(stopped.known) == 4 && numel(stopped.failures) == 1, 'no block is lost if the arm is stopped');
  check(isempty(planHandLook(2, state, 1, robotEye(), arm, sensor)), 'not if nothing is missing');
  arm.camera = '';
  state.handLooks = zeros(0, 2);
  check(isempty(planHandLook(1, state, [], robotEye(), arm, sensor)), 'nor without a camera');

  % The eye is taken for the camera of the hand. It sees a green cube, and again the top of the tower.
  arm.camera = 'right_hand';
  state.known = tower(4);
  [picture, heights] = pictureOf([block(green, cube, 1, -4, 0, 0), tower]);
  sensor.cameras.right_hand = struct('rgb', picture, 'depth', heights, 'pose', robotEye().pose, ...
                                     'intrinsics', robotEye().intrinsics);
  state = seeFromHand(state, sensor, arm);
  check(numel(state.known) == 2 && norm(state.known(1).position - [1, -4, 0.5]) < 0.05, 'what it sees is known');
  check(strcmp(state.notes(end).text, '1 more object with the right hand'), 'and told');
  checkLooksAside(state);
end

function checkLooksAside(state)
% An arm without a camera moves aside. Its hand is 3 units high, and 4 away from its first joint, which turns it about the vertical.
  eval('function points = armPoints(arm, q), points = [4 * sin(q(1)), 4 * cos(q(1)) - 6, 3; 0, -6, 3; 0, -6, 0]; end');
  eval('function path = moveJoints(arm, waypoints), path = waypoints(end, :); end');
  eval('function yes = isPathValid(varargin), yes = true; end');
  eval('function yes = isPathOver(varargin), yes = true; end');
  eval('function pose = smileForward(varargin), pose = eye(4); end');
  remove = onCleanup(@() clear('-f', 'armPoints', 'moveJoints', 'isPathValid', 'isPathOver', 'smileForward'));
  arm = struct('name', 'arm', 'index', 1, 'robot', [], 'parked', [0, 7], 'lower', [-1e4, -3], 'upper', [1e4, 3]);
  sensor.arms.joints = [0; 7];
  [actions, looked] = planLookAside([5, -1; 0, -1], state, robotEye(), arm, sensor);
  check(numel(actions) == 2 && actions{1}.path(2) == 7 && strcmp(actions{2}.kind, 'observe'), 'an arm moves aside from what it hides');
  check(isequal(looked.handLooks(end, :), [0, -1]), 'which is remembered');
  check(abs(actions{1}.path(1)) > 0.2 && abs(actions{1}.path(1)) < 1.5, 'no farther than necessary');
  check(isempty(planLookAside([5, -1], state, robotEye(), arm, sensor)), 'not if it does not hide it');

  green = [0, 1, 0]; red = [1, 0, 0]; cube = [1, 1, 1];
  state.steps = state.steps(1);
  state.known = [block(red, cube, 0, -2, 2.5, 0), block(green, cube, 0, -2, 2.5, 0), block(red, [4, 1, 1], 0, -4, 0, 0)];
  state = forgetArm(state, arm, sensor);
  check(isequal({state.known.position}, {[0, -2, 3], [0, -4, 0.5]}), 'what is no wanted thing and at the arm is a part of it');
end
