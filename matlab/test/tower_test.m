% Tests the parts of the tower example, without the simulator:
%
%   octave-cli matlab/test/tower_test.m
%
% prints "ok", or what is wrong, and exits with 0 or 1.
here = fileparts(mfilename('fullpath'));
addpath(fullfile(here, '..', 'examples', 'tower'));

function check(is_true, claim)
  if ~is_true, error('not so: %s', claim); end
end

function check_kinematics()
  % The tool's place at two of the poses in src/robot/test/data/baxter_fk_vectors.csv, from the mounts.
  zero = forwardKinematics(zeros(1, 7), 1);
  check(norm(zero - [-7.9128, 7.9128, 1.9135]) < 0.001, 'the arm is stretched at zero angles');
  bent = forwardKinematics([0, -0.55, 0, 0.75, 0, 1.26, 0], 2);
  check(norm(bent - [5.7630, 5.7630, 0.0843]) < 0.001, 'the neutral pose is where it should be');

  % The Jacobian agrees with small differences.
  q = [0.3, -0.6, 0.9, 1.2, -0.4, 0.8, 0.2];
  [place, ~, jacobian] = forwardKinematics(q, 1);
  for i = 1:7
    nudged = q;
    nudged(i) = q(i) + 1e-6;
    slope = (forwardKinematics(nudged, 1) - place) / 1e-6;
    check(norm(slope' - jacobian(1:3, i)) < 1e-4, 'the Jacobian is the slope of the kinematics');
  end
end

function check_inverse(arm)
  % All over the part of the table where blocks may lie, on the arm's own side and a little beyond.
  shape = armShape(arm);
  shoulders = [-2.59, -7.36, 3.296; 2.59, -7.36, 3.296];
  sides = [-1, 1];
  for x = [-0.4, 0, 1.3, 2.6, 4.2]
    for y = [-4.4, -3.4, -2.5, -1.6]
      for yaw = [-0.7, 0, 0.5]
        for height = [0.8, 1.8, 1.95]
          point = [sides(arm) * x, y, height];
          posture = toolPosture(point, yaw, shoulders(arm, :), arm);
          q = anglesFor(posture, arm);
          check(~isempty(q), sprintf('arm %d reaches %.1f %.1f %.1f', arm, point));
          check(all(q >= shape.lower & q <= shape.upper), 'joints keep their limits');
          [place, rotation] = forwardKinematics(q, arm);
          check(norm(place + shoulders(arm, :) - point) < 1e-5, 'the tool is where it is wanted');
          check(norm(rotation(:, 3) - [0; 0; -1]) < 1e-5, 'the fingers point down');
          across = atan2(rotation(2, 2), rotation(1, 2));
          check(abs(quarterTurn(across - yaw)) < 1e-5, 'the fingers lie along the sides');
          check(norm(postureOf(q, arm) - posture) < 1e-5, 'postureOf undoes anglesFor');
        end
      end
    end
  end
  check(isempty(anglesFor(toolPosture([0, 5, 1], 0, shoulders(arm, :), arm), arm)), ...
        'the far edge of the table is out of reach');
end

function check_motion()
  q = parkedAngles(2);
  goal = postureOf(q, 2) + [0.3, 0.5, -1, 0.2];
  motion = planMotion(q, goal, 2);
  check(norm(anglesAt(motion, 0) - q) < 1e-3, 'a motion begins where the arm is');
  check(norm(postureOf(anglesAt(motion, 99), 2) - goal) < 1e-5, 'a motion ends at its goal');
  shape = armShape(2);
  time = 0:1/60:motion.duration;
  last = q;
  for t = time(2:end)
    now = anglesAt(motion, t);
    check(all(abs(now - last) * 60 < shape.fastest), 'no joint is faster than it can');
    last = now;
  end
end

function check_demonstration()
  folder = tempname();
  mkdir(folder);
  write(folder, 0, {'0,create,B1,shape,block,color,red', '0,create,B2,shape,block,color,blue', ...
                    '0,create,B3,shape,block,color,green', '0,move,B1,1.0,2.0,0.5,0.0,-0.0,30.0', ...
                    '0,move,B2,-1.0,2.0,0.5,0.0,-0.0,0.0', '0,move,B3,5.0,2.0,0.5,0.0,-0.0,0.0'});
  write(folder, 1, {'3,grasp,AnyHand,B2', '5,move,B2,1.0,2.0,3.0,0.0,0.0,0.0'});
  write(folder, 2, {'8,release,AnyHand', '8,move,B2,1.0866025,2.05,1.5,1.0E-4,0.0,125.0'});
  demo = readDemonstration(folder);
  for name = {'0.txt', '1.txt', '2.txt'}
    delete(fullfile(folder, name{1}));
  end
  rmdir(folder);

  check(isequal(demo.ids, {'B1', 'B2', 'B3'}), 'the log names three objects');
  check(isequal(demo.placed, 2), 'B2 was let go of');
  steps = understandTower(demo);
  check(isequal({steps.color}, {'red', 'blue'}), 'red carries blue; green is no part of it');
  check(isequal([steps.support], [0, 1]), 'the second step stands on the first');
  check(norm(steps(2).offset - [0.1, 0]) < 1e-6, 'the offset is along the sides of the support');
  check(abs(steps(2).turn - 5 * pi / 180) < 1e-9, 'turned by 95 degrees is turned by 5');
end

function write(folder, segment, lines)
  file = fopen(fullfile(folder, sprintf('%d.txt', segment)), 'w');
  fprintf(file, '%s\n', lines{:});
  fclose(file);
end

function check_sight()
  % A camera like the robot's eye, 56 degrees downwards.
  f = 240 / tan(pi / 6);
  tilt = 56.05 * pi / 180;
  camera.intrinsics = [f 0 320; 0 f 240; 0 0 1];
  camera.pose = [1, 0, 0, 0; 0, -sin(tilt), cos(tilt), -6.1168; 0, -cos(tilt), -sin(tilt), 11.5921; ...
                 0, 0, 0, 1];
  yaws = [-40, -12.3, 0, 7.7, 31] * pi / 180;
  places = [-4, -4.2, 1; 4.1, -1.7, 1; 0.3, -3, 2; 2, -2.2, 3; -1.234, -3.456, 1];
  for i = 1:numel(yaws)
    image = draw_cube(ones(480, 640, 3), camera, places(i, :), yaws(i), [0, 1, 0]);
    image = draw_cube(image, camera, places(i, :) + [0, 2.6, 0], 0.2, [1, 0, 0]);
    block = findBlock(image, camera, 'green');
    check(~isempty(block), 'the green block is seen');
    check(norm(block.position - places(i, :)) < 0.02, 'it is where it was drawn');
    check(abs(quarterTurn(block.yaw - yaws(i))) < pi / 180, 'and turned as it was drawn');
    check(isempty(findBlock(image, camera, 'blue')), 'there is no blue block');
  end
end

function image = draw_cube(image, camera, top, yaw, color)
  % A pixel shows the first of some planes whose square holds the point on it: from the top downwards,
  % as the sides of a cube are the edges of squares below its top.
  [column, row] = meshgrid(1:640, 1:480);
  is_free = true(480, 640);
  for depth = 0:0.1:1
    [x, y] = ontoPlane(row(:), column(:), camera, top(3) - depth);
    along = (x - top(1)) * cos(yaw) + (y - top(2)) * sin(yaw);
    across = (y - top(2)) * cos(yaw) - (x - top(1)) * sin(yaw);
    is_hit = is_free & reshape(max(abs(along), abs(across)) <= 0.5, 480, 640);
    shade = 1;
    if depth > 0, shade = 0.7; end
    for channel = 1:3
      layer = image(:, :, channel);
      layer(is_hit) = shade * color(channel);
      image(:, :, channel) = layer;
    end
    is_free = is_free & ~is_hit;
  end
end

try
  check_kinematics();
  check_inverse(1);
  check_inverse(2);
  check_motion();
  check_demonstration();
  check_sight();
catch err
  fprintf('%s\n', err.message);
  exit(1);
end
fprintf('ok\n');
exit(0);
