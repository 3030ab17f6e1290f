% Tests the parts of the learner in matlab/learner, without the simulator:
%
%   octave-cli matlab/test/learner_test.m
%
% prints "ok" or the first wrong claim, and exits with 0 or 1. python/test/learner contains the same
% claims about the Python twin.
here = fileparts(mfilename('fullpath'));
addpath(fullfile(here, '..', 'learner'));

function check(is_true, claim)
  if ~is_true, error('not so: %s', claim); end
end

function eye = robotEye()
% Returns a camera like the robot's, tilted 56 degrees downward.
  f = 240 / tan(pi / 6);
  tilt = 56.05 * pi / 180;
  eye.intrinsics = [f, 0, 320; 0, f, 240; 0, 0, 1];
  eye.pose = [1, 0, 0, 0; 0, -sin(tilt), cos(tilt), -6.1168; 0, -cos(tilt), -sin(tilt), 11.5921; ...
              0, 0, 0, 1];
end

function it = block(color, size, x, y, bottom, yaw)
  it = newBlock(color, size, [x, y, bottom + size(3) / 2], yaw);
end

function now = updateBeliefs(known, seen, picture, eye, heights)
% Returns the known blocks after a look at a picture.
  if nargin < 5, heights = []; end
  tolerance = constants().blocks.position_tolerance;
  now = corrected(seen, verdictsOn(known, seen, picture, eye, heights, tolerance));
end

function [picture, heights] = pictureOf(blocks)
% Renders blocks as the eye sees them, lower ones first: 480x640x3; and the height of what each pixel shows,
% 480x640 [units].
  persistent planes;  % by height, where the pixels meet the horizontal plane
  if isempty(planes), planes = containers.Map('KeyType', 'double', 'ValueType', 'any'); end
  [column, row] = meshgrid(1:640, 1:480);
  flat = repmat([0.6, 0.5, 0.4], 480 * 640, 1);
  heights = zeros(480, 640);
  for it = blocks
    % Rectangles below each other form the sides. The top is drawn last.
    for height = it.position(3) + it.size(3) * (-5:2:5) / 10
      if ~isKey(planes, height)
        [x, y] = ontoPlane(row(:), column(:), robotEye(), height);
        planes(height) = [x, y];
      end
      points = planes(height);
      x = points(:, 1) - it.position(1);
      y = points(:, 2) - it.position(2);
      along = abs(x * cos(it.yaw) + y * sin(it.yaw));
      across = abs(y * cos(it.yaw) - x * sin(it.yaw));
      hit = along <= it.size(1) / 2 & across <= it.size(2) / 2;
      if isRound(it), hit = hypot(along, across) <= it.size(1) / 2; end
      shade = 0.7;
      if height == it.position(3) + it.size(3) / 2, shade = 1; end
      flat(hit, :) = repmat(shade * it.color, sum(hit), 1);
      heights(hit) = height;
    end
  end
  picture = reshape(flat, 480, 640, 3);
end

function check_perception()
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1];
  cube = [1, 1, 1]; plank = [4, 1, 1];
  blocks = [block(red, plank, -2.5, -1.2, 0, 0.4), block(green, cube, 2, -3.1, 0, -0.3), ...
            block(red, cube, 4, -2, 0, 0), block(blue, cube, 4, -2, 1, 0.2), ...
            block(green, plank, 0.2, -2.6, 0, pi / 2 - 0.1)];
  found = detectBlocks(pictureOf(blocks), robotEye(), blocks, []);
  blocks(3) = [];
  check(numel(found) == numel(blocks), 'all are detected except the one below another');
  for it = blocks
    same = found(arrayfun(@(other) norm(other.position - it.position) < 0.01, found));
    check(numel(same) == 1, 'a block is detected within a hundredth of a unit');
    check(isequal(same.size, it.size), 'with its size');
    check(abs(yawDifference(it, same.yaw)) < 0.5 * pi / 180, 'and its yaw');
  end

  seen = [block(red, cube, 1, -2, 0, 0), block(red, [2.5, 1, 1], -2, -2, 0, 0), ...
          block(blue, cube, 3, -2, 0, 0)];
  check(isequal({detectBlocks(pictureOf(seen), robotEye(), seen(1), []).color}, {red}), ...
        'only blocks of the wanted size and color are detected');
  found = detectBlocks(pictureOf(seen), robotEye(), block([], cube, 0, 0, 0, 0), []);
  check(isequal({found.color}, {blue, red}), 'of any color where color does not matter');

  row = [block(red, cube, -2, -2, 0, 0.3), ...
         block(red, cube, -2 + cos(0.3), -2 + sin(0.3), 0, 0.3)];
  found = detectBlocks(pictureOf(row), robotEye(), row, []);
  check(numel(found) == 2 && norm(found(1).position - row(1).position) < 0.02 && ...
        norm(found(2).position - row(2).position) < 0.02, 'two blocks that touch are separated');

  % The eye sees a large cube like a small one higher up; but nothing would support the small one.
  large = block(red, [1.3, 1.3, 1.25], 2, -3, 0, 0.2);
  picture = pictureOf([large, block(blue, cube, -2, -2, 0, 0)]);
  found = detectBlocks(picture, robotEye(), block(red, cube, 0, 0, 0, 0), []);
  check(isempty(found), 'a larger cube is not taken for a small one higher up');
  found = detectUnknownObjects(picture, robotEye(), block(blue, cube, -2, -2, 0, 0));
  check(numel(found) == 1 && norm(found.position - large.position) < 0.03 && ...
        max(abs(found.size - large.size)) < 0.05, 'an unknown object is detected, too');

  mask = logical([0, 1, 0, 1; 1, 1, 0, 1; 0, 0, 1, 0; 1, 0, 1, 1]);
  check(isequal(labelRegions(mask), [0, 1, 0, 4; 1, 1, 0, 4; 0, 0, 3, 0; 2, 0, 3, 3]), ...
        'regions are numbered by their first pixel');
end

function check_depth()
  red = [1, 0, 0]; blue = [0, 0, 1];
  cube = [1, 1, 1]; half = [1, 1, 0.5];
  eye = robotEye();
  [~, heights] = pictureOf([block(red, cube, 1, -2, 0, 0), block(blue, cube, -2, -3, 1.5, 0)]);
  [column, row] = meshgrid((1:640) - 0.5, (1:480) - 0.5);
  down = reshape(eye.pose(3, 1:3) * (eye.intrinsics \ [column(:), row(:), ones(640 * 480, 1)]'), 480, 640);
  found = heightMap((heights - eye.pose(3, 4)) ./ down, eye);
  check(max(abs(found(:) - heights(:))) < 1e-9, 'depth determines heights');
  check(~any(heightMap(zeros(480, 640), eye)(:)), 'which are 0 where there is no surface');

  % Seen from the eye, the far edge of the tower meets the near edge of the block behind it.
  blocks = [block(red, cube, 0, -1.62, 0, 0), block(red, cube, 0.2, -3, 0, 0), block(red, cube, 0.2, -3, 1, 0)];
  [picture, heights] = pictureOf(blocks);
  found = detectBlocks(picture, eye, blocks, [], heights);
  check(numel(found) == 2, 'depth separates equal colors that touch at several heights');
  for it = blocks([1, 3])
    check(min(arrayfun(@(other) norm(other.position - it.position), found)) < 0.01, 'at their places');
  end

  [picture, heights] = pictureOf([block(red, cube, -2, -2, 0, 0), block(red, half, 2, -2, 0, 0), ...
                                  block(red, half, 2, -2, 0.5, 0)]);
  on_half = block(red, half, 0, 0, 0.5, 0);
  found = detectBlocks(picture, eye, on_half, [], heights);
  check(isequal({found.size}, {half, half}), 'two halves are expected');
  found = detectBlocks(picture, eye, [block(red, cube, 0, 0, 0, 0), on_half], [], heights);
  check(isequal({found.size}, {cube, cube}), 'or one block');

  lower = block(red, [2, 2, 0.7], 1, -2, 0, 0);
  upper = block(blue, cube, 1, -2, 0.7, 0);
  [picture, heights] = pictureOf([lower, upper]);
  found = detectUnknownObjects(picture, eye, lower, heights);
  check(numel(found) == 1 && norm(found.position - upper.position) < 0.03 && ...
        max(abs(found.size - upper.size)) < 0.05, 'unknown objects are detected on others');
  [picture, heights] = pictureOf(emptyBox([0.5, 0.3, 0.2], 1, -2, 0));
  check(isempty(detectUnknownObjects(picture, eye, noBlocks(), heights)), 'the floor of a box is none');

  post = block(blue, [1, 1, 3], 0.3, -2.2, 0, 0);
  behind = block(red, cube, 0, -1, 0, 0);
  beside = block(red, cube, 3, -1, 0, 0);
  check(isTopHidden(behind, [beside, post], eye), 'a higher block hides what is behind it');
  check(~isTopHidden(beside, [behind, post], eye) && ~isTopHidden(post, [behind, beside, post], eye), ...
        'and nothing else');

  seen = block(red, cube, 0.05, -1, 0, 0.4);
  picture = pictureOf([behind, post]);
  check(isequal(updateBeliefs(behind, [seen, post], picture, eye), [behind, post]), ...
        'a half-hidden block is where it was known to be');
  check(isequal(updateBeliefs(behind, seen, picture, eye), seen), 'any other is where it is seen');
  tower = [block(red, cube, 0, -4, 0, 0), block([0, 1, 0], cube, 0, -4, 1, 0)];
  missing = [block(blue, cube, 3, -2, 0, 0), block(blue, cube, 0, -4, 2, 0)];
  [picture, heights] = pictureOf(tower);
  known = updateBeliefs([tower(1), missing], tower(2), picture, eye, heights);
  check(isequal(known, tower([2, 1])), 'a hidden block is remembered, missing ones are not');

  shifted = [block(red, cube, 3, -1, 0, 0.5), block(red, cube, -3, -1.1, 0, 0)];
  there = [shifted(1), block(red, cube, -3, -1, 0, 0)];
  [picture, heights] = pictureOf([tower, there]);
  verdicts = verdictsOn([tower, missing(1), shifted], [tower(2), there], picture, eye, heights, 0.07);
  words = {'hidden', 'as expected', 'contradicted', 'as expected', 'contradicted'};
  check(isequal({verdicts.word}, words), 'each expectation has its verdict');
  notes = verdictNotes(verdicts, [tower(2), there], noBlocks(), 'Red1');
  check(strcmp(notes(1).text, 'Red1: off by 0.10 units and 0.0 degrees'), 'how far off the moved block is');
  check(isequal({notes.word}, {'contradicted', 'as expected', 'hidden', 'contradicted'}), 'and the others');
  check(isequal(topsOf(notes(1)), [1, 0, -3, -1.1, 1, 1, 1, 0, 0; 1, 1, -3, -1, 1, 1, 1, 0, 0]), 'with their tops');
end

function [picture, heights] = withBall(picture, heights, color, center, radius)
% Renders a ball into a picture and its heights.
  eye = robotEye();
  [column, row] = meshgrid((1:640) - 0.5, (1:480) - 0.5);
  ray = (eye.intrinsics \ [column(:), row(:), ones(640 * 480, 1)]')' * eye.pose(1:3, 1:3)';
  ray = ray ./ sqrt(sum(ray .^ 2, 2));
  to_center = center - eye.pose(1:3, 4)';
  along = ray * to_center';
  inside = radius ^ 2 - (to_center * to_center' - along .^ 2);
  hit = inside > 0;
  z = eye.pose(3, 4) + ray(hit, 3) .* (along(hit) - sqrt(inside(hit)));
  flat = reshape(picture, [], 3);
  flat(hit, :) = (0.8 + 0.2 * (z - center(3)) / radius) * color;
  picture = reshape(flat, 480, 640, 3);
  heights(hit) = z;
end

function check_forms()
  red = [1, 0, 0]; green = [0, 1, 0]; brown = [0.5, 0.3, 0.2];
  cube = [1, 1, 1];
  eye = robotEye();
  plate = block(green, [1.8, 1.8, 0.2], -2, -2.5, 0, 0.3);
  [picture, heights] = pictureOf([plate, block(red, cube, -2, -2.4, 0.2, 0.5)]);
  check(isempty(detectBlocks(picture, eye, plate, [], heights)), 'a partly covered block is not detected');
  found = detectBlocks(picture, eye, plate, [], heights, plate);
  check(norm(found.position - plate.position) < 0.02 && abs(yawDifference(plate, found.yaw)) < pi / 180, ...
        'unless it is known to carry others');
  is_higher = heights > 0.5;
  heights(is_higher) = 0;
  picture(repmat(is_higher, 1, 1, 3)) = 0.5;
  check(isempty(detectBlocks(picture, eye, plate, [], heights, plate)), 'a hole that nothing hides is another shape');

  disc = newBlock(red, cube, [-1, -2, 0.5], 0, 'disc');
  square = block(red, cube, 2, -2, 0, 0.3);
  [picture, heights] = pictureOf([disc, square]);
  for wanted = [disc, square]
    found = detectBlocks(picture, eye, wanted, [], heights);
    check(norm(found.position - wanted.position) < 0.01 && strcmp(found.form, wanted.form), ...
          'discs are distinguished from squares');
  end
  check(numel(graspYaws(disc, noBlocks())) == 8 && yawDifference(disc, 1) == 0, 'a disc looks the same at each yaw');
  unknown = detectUnknownObjects(picture, eye, square, heights);
  check(isRound(unknown) && max(abs(unknown.size - disc.size)) < 0.02, 'an unknown disc is detected as one');

  center = [-1, -2.5, 0.35];
  [picture, heights] = pictureOf(block(brown, cube, 2, -2, 0, 0));
  [picture, heights] = withBall(picture, heights, red, center, 0.35);
  check(max(abs(ballColor(picture, eye, center, 0.35) - red)) < 0.1, 'a ball has an outline of one hue');
  check(isempty(ballColor(picture, eye, [2, -2, 0.5], 0.5)), 'a cube has not');
  heights(:, 1:280) = 0;  % a part is hidden
  found = detectBlocks(picture, eye, newBlock(red, 0.7 * cube, center, 0, 'ball'), [], heights);
  check(norm(found.position - center) < 0.01, 'a partly hidden ball is detected by its surface');
  larger = newBlock(red, 0.8 * cube, center, 0, 'ball');
  check(isempty(detectBlocks(picture, eye, larger, [], heights)), 'one of another size is not');

  plate = block(green, [1.8, 1.8, 0.2], -2, -2.5, 0, 0);
  tower = block(red, [1, 1, 2], -2, -2.5, 0.2, 0);
  [~, heights] = pictureOf([plate, tower]);
  points = unexplainedPoints(tower, heights, eye);
  places = footprint([block(red, cube, -2, -1.7, 0, 0), block(red, cube, -3.2, -2.5, 0, 0), ...
                      block(red, cube, 2, -2, 0, 0)], 0);
  check(isequal(isUnexplained(places, points), logical([1; 1; 0])), 'nothing is put where something unexplained is');
  check(isempty(unexplainedPoints([tower, plate], heights, eye)), 'known blocks are explained');
end

function estimates = estimatesWhile(truths, told, noise)
% Returns the estimates of one arm of two joints that begins at [0; 0], 2xN.
  randn('seed', 1);
  joints = jointEstimates({[0; 0]});
  estimates = zeros(size(truths));
  for k = 1:size(truths, 2)
    sensor.timeElapsed = 1 / 60;
    sensor.arms = struct('joints', truths(:, k) + noise * randn(2, 1));
    [joints, sensor] = correctJoints(joints, sensor, 1 / 60);
    joints.told = {told(:, k)};
    estimates(:, k) = sensor.arms.joints;
  end
end

function check_noise()
  told = [zeros(2, 20), repmat([0.5; -0.5], 1, 60), zeros(2, 20)];
  truths = cumsum([[0; 0], told(:, 1:end - 1)], 2) / 60;
  pushed = truths + [zeros(2, 90), repmat(0.1, 2, 10)];
  check(isequal(estimatesWhile(pushed, told, 0), pushed), 'sensors without noise are believed');
  errors = abs(estimatesWhile(truths, told, 0.01) - truths);
  check(max(errors(:)) < 0.004, 'noisy joints are where the motors brought them');
  told = [zeros(2, 20), repmat([0.2; 0], 1, 120)];
  blocked = estimatesWhile(zeros(2, 140), told, 0.01);
  check(max(abs(blocked(:))) < 0.1, 'joints stop at an obstacle whatever the motors are told');

  picture = pictureOf(block([1, 0, 0], [4, 1, 1], 0, -2, 0, 0));
  check(numPictures(picture) == 1, 'one picture without noise is enough');
  count = numPictures(picture + 0.02 * randn(size(picture)));
  check(abs(count - 16) <= 1, 'noisy pictures are taken repeatedly');
end

function check_clearance()
  [a, b] = meshgrid((-20:20) / 40);
  share = [a(:), b(:)];
  one = [0.3, -0.2, 2.0, 0.7, 0.4];
  many = [5 * halton(200, 2) - 2.5, 5 * halton(200, 3) - 2.5, 0.5 + 2.5 * halton(200, 5), ...
          0.5 + 2.5 * halton(200, 7), 8 * halton(200, 11) - 4];
  answers = overlap(one, many);
  check(isequal(overlap([one; many(1, :)], many), [answers, overlap(many(1, :), many)]), 'or of several');
  for i = 1:rows(many)
    % Points lie up to 0.08 apart, so rectangles as much larger or smaller bracket the truth.
    if haveCommonPoint(one, many(i, :), share, -0.15), check(answers(i), 'these overlap'); end
    if ~haveCommonPoint(one, many(i, :), share, 0.15), check(~answers(i), 'these are apart'); end
  end
  check(sum(answers) > 30 && sum(~answers) > 30, 'both answers occur');

  red = [1, 0, 0];
  middle = block(red, [1, 1, 1], 0, -2, 0, 0);
  beside = [block(red, [1, 1, 1], -1.1, -2, 0, 0), block(red, [1, 1, 1], 1.1, -2, 0, 0)];
  before = block(red, [1, 1, 1], 0, -3.1, 0, 0);
  check(numel(graspYaws(middle, noBlocks())) == 4, 'a single cube can be grasped with four yaws');
  yaws = graspYaws(middle, beside);
  check(numel(yaws) == 2 && all(abs(cos(yaws)) < 1e-9), 'between two others in one direction');
  check(isempty(graspYaws(block(red, [4, 1, 1], 0, -3.1, 0, 0), middle)), 'and sometimes not at all');
  check(isGraspBlocked(middle, [beside, before]), 'with a third block in front, the grasp is blocked');
  check(~isGraspBlocked(middle, block(red, [1, 1, 1], 4, -2, 0, 0)), 'but not by a distant block');
end

function numbers = halton(count, base)
% Returns numbers between 0 and 1 of low discrepancy (Halton's sequence).
  numbers = zeros(count, 1);
  for i = 1:count
    share = 1;
    rest = i;
    while rest > 0
      share = share / base;
      numbers(i) = numbers(i) + share * mod(rest, base);
      rest = floor(rest / base);
    end
  end
end

function yes = haveCommonPoint(one, other, share, grow)
  c = cos(other(5));
  s = sin(other(5));
  points = (share .* (other(3:4) + grow)) * [c, s; -s, c] + other(1:2) - one(1:2);
  c = cos(one(5));
  s = sin(one(5));
  yes = any(all(abs(points * [c, -s; s, c]) <= (one(3:4) + grow) / 2, 2));
end

function check_inference()
% A plank stays; a red cube is put on it, another stays, and a blue cube is moved twice.
  names = {'Plank', 'Red', 'Other', 'Blue'};
  objects = [block([0, 1, 0], [1, 4, 1], -2, -2, 0, 0.2), block([1, 0, 0], [1, 1, 1], 3, -3, 0, 0), ...
             block([1, 0, 0], [1, 1, 1], 3, -1, 0, 0), block([0, 0, 1], [1, 1, 1], 1, -4, 0, 0)];
  [folder, remove] = newRecording({pictureOf(objects)});
  lines = {};
  for i = 1:4, lines{end + 1} = sprintf('0,create,%s,shape,block', names{i}); end
  for i = 1:4
    lines{end + 1} = sprintf('0,move,%s,%.3f,%.3f,%.3f,0.0,-0.0,%.12f', names{i}, ...
                             objects(i).position, objects(i).yaw * 180 / pi);
  end
  write(folder, '0.txt', lines);
  write(folder, '1.txt', {'3,grasp,LeftHand,Blue', '5,move,Blue,0.0,-4.0,2.0,0.0,0.0,0.0', ...
                          '6,release,LeftHand', '6,move,Blue,0.0,-4.0,0.5,0.0,0.0,0.0'});
  write(folder, '2.txt', {'7,grasp,AnyHand,Red', '9,release,AnyHand', ...
                          '9,move,Red,-2.0,-1.5,1.5,1.0E-4,0.0,95.0', '10,grasp,LeftHand,Blue', ...
                          '11,release,LeftHand', '11,move,Blue,-2.0,-1.5,2.5,0.0,0.0,0.0'});

  demo = readDemonstration(folder);
  steps = inferTask(demo, struct('object', {'Blue'}, 'properties', {{'size'}}));
  check(isequal({steps.name}, {'Plank', 'Red', 'Blue'}), 'steps come in the order of building');
  check(isequal({steps.on}, {[], 1, 2}), 'each stands on the one before');
  check(max(abs(steps(1).size - [4, 1, 1])) < 0.03, 'the longer side of the plank comes first');
  check(abs(yawDifference(steps(1), 0.2 + pi / 2)) < 1e-9, 'and determines its yaw');
  check(norm(steps(2).position - [-2, -1.5, 1.5]) < 1e-9, 'the last move determines the position');
  check(abs(steps(2).yaw - 95 * pi / 180) < 1e-9, 'and the yaw');
  check(max(abs(steps(2).color - [1, 0, 0])) < 0.01, 'the color is read from the picture');
  check(isequal([steps.stays], [true, false, false]), 'what was not moved stays');
  check(isempty(steps(3).color), 'the demonstrator specified that only the size of Blue matters');

  steps = inferTask(demo, struct('object', {'Red'}, 'properties', {{'color', 'size', 'order'}}));
  check(isequal({steps.after}, {[], [], 2}), 'an order that matters is kept');

  [~, container, appearances] = inferTask(demo, []);
  [keyframes, goal] = explain(demo, appearances, container);
  check(isequal({keyframes.deed}, {'', 'LeftHand carries Blue', 'AnyHand carries Red', 'LeftHand carries Blue'}), ...
        'each carry is a deed');
  check(isequal([keyframes.isMeans], [false, true, false, false]), 'what is not kept is a means');
  check(any(strcmp(keyframes(3).facts, 'on Blue table')), 'facts are those before the next deed');
  check(isequal(goal, {'on Red Plank', 'place Red Plank 0.10 0.49 84', 'on Blue Red', ...
                       'place Blue Red 0.00 0.00 -95'}), 'the goal is what is made and kept');
  cut = struct('word', 'use', 'fields', {{'LeftHand', 'Knife', 'cut', 'String between link 1 and 2'}});
  world = worldAfter(cut, struct('held', struct(), 'names', {{}}, 'values', {{}}), {});
  check(isequal([world.names, world.values], {'cut String', 'Knife'}), 'what was cut is a fact');

  delete(fullfile(folder, 'rgb', '0.png'));
  message = '';
  try
    inferTask(demo, []);
  catch problem
    message = problem.message;
  end
  check(~isempty(strfind(message, 'no picture of the demonstration shows Red')), ...
        'an invisible object is reported');

  file = fopen(fullfile(folder, 'demo.json'), 'w');
  fputs(file, '{"meters_per_unit": 0.1, "eye": null}');
  fclose(file);
  try
    readDemonstration(folder);
  catch problem
    message = problem.message;
  end
  check(~isempty(strfind(message, 'has no pictures')), 'a recording without pictures is reported');
end

function check_unstacking()
% A tower is taken apart. Its lower blocks, a half and a cube, are visible only later.
  cube = [1, 1, 1];
  tower = [block([1, 0, 0], [1, 1, 0.5], -2, -2, 0, 0), block([0, 1, 0], cube, -2, -2, 0.5, 0), ...
           block([0, 0, 1], cube, -2, -2, 1.5, 0)];
  apart = tower;
  for k = 1:3, apart(k).position = [2 * k - 4, -3, tower(k).size(3) / 2]; end
  [folder, remove] = newRecording({pictureOf(tower), pictureOf([tower(1:2), apart(3)]), ...
                                   pictureOf([tower(1), apart(2:3)])});
  names = {'Red', 'Green', 'Blue'};
  move = @(frame, k, position) sprintf('%d,move,%s,%g,%g,%g,0.0,0.0,0.0', frame, names{k}, position);
  lines = cellfun(@(name) ['0,create,', name, ',shape,block'], names, 'UniformOutput', false);
  for k = 1:3, lines{end + 1} = move(0, k, tower(k).position); end
  write(folder, '0.txt', lines);
  lines = {};
  for frame = 1:3
    k = 4 - frame;
    lines = [lines, {sprintf('%d,grasp,AnyHand,%s', frame, names{k}), move(frame, k, [3, 0, 4.5]), ...
                     move(frame, k, apart(k).position), sprintf('%d,release,AnyHand', frame)}];
  end
  write(folder, '1.txt', lines);
  steps = inferTask(readDemonstration(folder), []);
  check(isequal({steps.name}, {'Blue', 'Green', 'Red'}), 'the highest comes first');
  sizes = vertcat(steps.size);
  check(max(max(abs(sizes - [1, 1, 1; 1, 1, 1; 1, 1, 0.5]))) < 0.03, 'heights follow from what is below');
  check(isempty([steps.on]), 'all are put on the table');
end

function [folder, remove] = newRecording(pictures)
% Creates a folder for the texts of a recording, with these pictures; clearing `remove` deletes it.
  folder = tempname();
  mkdir(folder);
  mkdir(folder, 'rgb');
  remove = onCleanup(@() removeFolder(folder));
  for i = 1:numel(pictures)
    imwrite(uint8(255 * pictures{i}), fullfile(folder, 'rgb', sprintf('%d.png', i - 1)));
  end
  eye = robotEye();
  tilt = -(90 + 56.05) / 2 * pi / 180;
  info.meters_per_unit = 0.1;
  info.eye = struct('fx', eye.intrinsics(1, 1), 'fy', eye.intrinsics(2, 2), 'cx', 320, 'cy', 240, ...
                    'position_m', eye.pose(1:3, 4)' / 10, ...
                    'rotation_wxyz', [cos(tilt), sin(tilt), 0, 0]);
  write(folder, 'demo.json', {jsonencode(info)});
end

function removeFolder(folder)
  confirm_recursive_rmdir(false, 'local');
  rmdir(folder, 's');
end

function write(folder, name, lines)
  file = fopen(fullfile(folder, name), 'w');
  fprintf(file, '%s\n', lines{:});
  fclose(file);
end

function check_container()
% A blue cube is put into a box whose floor is 0.2 high. Then the box is detected elsewhere, rotated.
  brown = [0.5, 0.3, 0.2]; blue = [0, 0, 1];
  cube = block(blue, [1, 1, 1], 3, -3, 0, 0);
  [folder, remove] = newRecording({pictureOf([emptyBox(brown, -1, -1, 0), cube])});
  write(folder, '0.txt', {'0,create,Case,shape,box', '0,create,Blue,shape,block', ...
                          '0,move,Case,-1.0,-1.0,0.45,0.0,0.0,0.0', ...
                          '0,move,Blue,3.0,-3.0,0.5,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Blue', '2,release,LeftHand', ...
                          '2,move,Blue,0.5,-1.3,0.7,0.0,0.0,0.0'});
  [steps, container] = inferTask(readDemonstration(folder), []);
  check(norm(container.position - [-1, -1, 0.45]) < 0.03, 'the box is measured where it stands');
  check(max(abs(container.size - [5, 2.6, 0.9])) < 0.05, 'with its size');
  check(abs(container.floor - 0.2) < 1e-9, 'the height of its content determines that of its floor');

  there = block(blue, [1, 1, 1], 0.9, -1.6, 0.2, 0.3);
  picture = pictureOf([emptyBox(brown, 1, -2, 0.3), there]);
  [found, turn] = detectContainer(picture, robotEye(), container);
  check(norm(found.position - [1, -2, 0.45]) < 0.03, 'the box is detected elsewhere');
  check(abs(turn - 0.3) < 0.02, 'with its rotation');
  seen = detectBlocks(picture, robotEye(), steps, found);
  check(abs(seen.position(3) - 0.7) < 1e-9, 'a block in it lies on its floor');
  walls = containerWalls(found);
  there.position = found.position + [0, 0, 0.25];
  check(isequal(graspYaws(there, walls), there.yaw + [pi / 2, -pi / 2, 0, pi]), ...
        'there is room for the fingers in the middle');
  there.position = found.position + [1.7 * [cos(0.3), sin(0.3)], 0.25];
  check(isequal(graspYaws(there, walls), there.yaw + [pi / 2, -pi / 2]), 'but not at the end');
end

function blocks = emptyBox(color, x, y, yaw)
% Returns blocks that look like an open box: its rim, a dark side inside, and its floor.
  blocks = [block(color, [5, 2.6, 0.9], x, y, 0, yaw), block(0.7 * color, [4.6, 2.2, 0], x, y, 0.9, yaw), ...
            block(color, [4.2, 1.8, 0], x, y, 0.9, yaw)];
end

function blocks = lid(x, y, bottom)
% Returns a lid and its knob.
  blocks = [block([0.75, 0.45, 0.3], [2.8, 2.8, 0.2], x, y, bottom, 0), ...
            block([0, 0, 1], [0.6, 0.6, 0.7], x, y, bottom + 0.2, 0)];
end

function blocks = pot(x, y)
% Returns the floor of a pot and its walls, the far ones first.
  color = [0.5, 0.3, 0.2];
  blocks = [block(color, [2.3, 2.3, 0.2], x, y, 0, 0), block(color, [2.5, 0.2, 1.5], x, y + 1.15, 0, 0), ...
            block(color, [0.2, 2.5, 1.5], x + 1.15, y, 0, 0), block(color, [0.2, 2.5, 1.5], x - 1.15, y, 0, 0), ...
            block(color, [2.5, 0.2, 1.5], x, y - 1.15, 0, 0)];
end

function check_lid()
% A lid with a knob is put beside a pot, a red cube into the pot, and the lid on the pot again.
  red = [1, 0, 0];
  cube = block(red, [1, 1, 1], 3, -3, 0, 0);
  [folder, remove] = newRecording({pictureOf([lid(-2, -2, 1.5), cube]), ...
                                   pictureOf([pot(-2, -2), lid(2, 0, 0), cube]), pictureOf(lid(-2, -2, 1.5))});
  write(folder, '0.txt', {'0,create,Pot,shape,box', '0,create,Lid,shape,composite', '0,create,Red,shape,block', ...
                          '0,move,Pot,-2.0,-2.0,0.75,0.0,0.0,0.0', '0,move,Lid,-2.0,-2.0,1.6,0.0,0.0,0.0', ...
                          '0,move,Red,3.0,-3.0,0.5,0.0,0.0,0.0'});
  write(folder, '1.txt', {'0,grasp,LeftHand,Lid', '1,move,Lid,2.0,0.0,0.1,0.0,0.0,0.0', '1,release,LeftHand', ...
                          '1,grasp,LeftHand,Red', '2,move,Red,-2.0,-2.0,0.7,0.0,0.0,0.0', '2,release,LeftHand', ...
                          '2,grasp,LeftHand,Lid', '2,move,Lid,-2.0,-2.0,1.6,0.0,0.0,0.0', '2,release,LeftHand'});
  [steps, container] = inferTask(readDemonstration(folder), []);
  check(isequal({steps.name}, {'Red', 'Lid'}) && isequal({steps.after}, {[], 1}), 'a lid covers what is inside');
  check(isequal([steps.hasKnob], [false, true]) && isequal([steps.beginsThere], [false, true]), ...
        'it has a knob and begins where it ends');
  check(max(abs(steps(2).size - [2.8, 2.8, 0.2])) < 0.08, 'it is measured around its knob');

  [picture, heights] = pictureOf([lid(1, -2, 1.5), block(red, [1, 1, 1], -3, -2, 0, 0)]);
  state = observe(initialTaskState(steps, container), picture, heights, robotEye());
  k = find(~cellfun(@isempty, {state.known.knob}));
  check(norm(heldPart(state.known(k)).position - [1, -2, 2.05]) < 0.05, 'its knob is found in the scene');
  check(numel(graspYaws(state.known(k), noBlocks())) == 4, 'and it is held by it');
  state = chooseSite(state, [], picture, robotEye());
  check(norm(state.container.position - [1, -2, 0.75]) < 0.05, 'the pot is below the lid');
  [state, used] = assessProgress(state);
  moves = proposeMoves(state, 1, find(~used));
  check(~any(state.done) && moves(1).block == k, 'the lid is taken off before anything is put inside');
end

function check_dragging()
% A door with a post on it is dragged by 2 and 1; another post of the same color stays.
  yellow = [0.9, 0.7, 0.1]; red = [0.7, 0.3, 0.2];
  door = @(x, y) [block(yellow, [3, 2, 2], x, y, 0, 0.5), block(red, [1, 0.6, 1.2], x, y, 2, 0.5)];
  other = block(red, [1, 0.6, 1.2], 4, -4, 0, 0);
  [folder, remove] = newRecording({pictureOf([other, door(-2, -3)]), pictureOf([other, door(0, -2)])});
  write(folder, '0.txt', {'0,create,Door,shape,composite', '0,move,Door,-2.2,-3.1,1.9,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Door', '1,move,Door,-0.2,-2.1,1.9,0.0,0.0,0.0', ...
                          '1,release,LeftHand'});
  [step, container] = inferTask(readDemonstration(folder), []);
  check(isempty(container), 'there is no container');
  check(norm(step.displacement - [2, 1]) < 1e-9, 'it was dragged');
  check(abs(step.position(3) + step.size(3) / 2 - 3.2) < 0.05, 'its displacement in the pictures determines the height');
  check(norm(step.position(1:2) - [-2, -3]) < 0.03 && max(abs(step.size(1:2) - [1, 0.6])) < 0.03, ...
        'its post is the handle');

  state = initialTaskState(step, []);
  state.known = block(step.color, step.size, 3, -2, 0, 0.8);
  state = chooseSite(state, [], [], []);
  turn = [cos(0.3), sin(0.3); -sin(0.3), cos(0.3)];
  check(state.hasSite && norm(state.steps.position(1:2) - [3, -2] - [2, 1] * turn) < 0.01, ...
        'the displacement of a rotated door is rotated');
  state = initialTaskState(step, []);
  [state, problem] = chooseSite(state, [], [], []);
  check(~state.hasSite && ~isempty(strfind(problem, '0 visible objects look like')), ...
        'an invisible door is not dragged');
  delete(fullfile(folder, 'rgb', '1.png'));
  message = '';
  try
    inferTask(readDemonstration(folder), []);
  catch problem
    message = problem.message;
  end
  check(~isempty(strfind(message, 'the handle of Door')), 'an invisible handle is reported');
end

function check_planning()
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1];
  cube = [1, 1, 1];
  steps = [asStep(block(red, cube, 0, -2, 0, 0)), asStep(block(green, cube, 0, -2, 1, 0)), ...
           asStep(block(green, cube, -3, -2, 0, 0))];
  state = initialTaskState(steps, []);
  state.known = [block(red, cube, 0.1, -2, 0, 0), block(red, cube, 0.05, -2, 0, pi), ...
                    block(red, cube, 0, -2, 1, 0)];
  [state, used] = assessProgress(state);
  check(isequal(used, logical([0, 1, 0])), 'a block close to its place is in it');
  check(isequal(state.done, logical([1, 0, 0])), 'so the step is done');

  state.known = [block(red, cube, 4, -3, 0, 0), block(red, cube, 3, -2, 0, 0), ...
                    block(blue, cube, 0.3, -2.2, 0, 0), block(blue, cube, 3, -2, 1, 0)];
  moves = proposeMoves(state, 1, 1:4);
  check(isequal([moves.block], [3, 4]), 'obstructing blocks come first, without a goal');
  check(all(cellfun(@isempty, {moves.goal})), 'neither goes to the place of a red one');
  moves = proposeMoves(state, 1, [1, 2, 4]);
  check(isequal([moves.block], [1, 4]), 'then a matching block; a covered one waits');
  check(isequal(cellfun(@isempty, {moves.goal}), logical([0, 1])), 'only red ones have a goal');

  tower = [block(red, cube, 0, -4, 0, 0), block(green, cube, 0, -4, 1, 0)];
  missing = block(blue, cube, 3, -2, 0, 0);
  known = updateBeliefs([tower(1), missing], tower(2), pictureOf(tower), robotEye());
  check(isequal(known, tower([2, 1])), 'a hidden block is remembered, a missing one is not');
end

function check_site()
% The building is where the demonstration moved nothing.
  eye = robotEye();
  brown = [0.5, 0.3, 0.2];
  bases = [asStep(block(brown, [4, 1, 1], 1, -2, 0, 0.1)), asStep(block(brown, [1, 1, 1], 1, 0, 0, 0))];
  [bases.stays] = deal(true);
  state = initialTaskState(bases, []);
  state.known = [block(brown, [4, 1, 1], -2, -2, 0, 0.1 - pi / 2), block(brown, [1, 1, 1], 0, -2, 0, 0), ...
                 block(brown, [4, 1, 1], 3, -2, 0, 0.3)];
  state = chooseSite(state, [], [], eye);
  errors = vertcat(state.steps.position) - vertcat(state.known(1:2).position);
  check(state.hasSite && max(abs(errors(:))) < 1e-9, ...
        'what stays determines the site');

  % Each of two plates, arranged differently here, has a step on it.
  plates = [asStep(block(brown, [2, 2, 0.2], -2, 1, 0, 0)), asStep(block([0, 0, 1], [2, 2, 0.2], 2, 1, 0, 0))];
  [plates.stays] = deal(true);
  known = [block(brown, [2, 2, 0.2], -3, -2, 0, 0), block([0, 0, 1], [2, 2, 0.2], 2, -3, 0, 0.3)];
  on_plates = [asStep(block(brown, [1, 1, 1], -2, 1, 0.2, 0)), asStep(block(brown, [1, 1, 1], 2, 1.2, 0.2, 0))];
  [on_plates.stays] = deal(true);  % no arm has to reach them
  known = [known, block(brown, [1, 1, 1], -3, -2, 0.2, 0), ...
           block(brown, [1, 1, 1], 2 - 0.2 * sin(0.3), -3 + 0.2 * cos(0.3), 0.2, 0.3)];
  moved = placeByWhatStays([plates, on_plates], known, [], eye);
  errors = vertcat(moved.position) - vertcat(known.position);
  check(max(abs(errors(:))) < 1e-9, 'each object that stays determines where the steps on it go');
end

function check_clearing()
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1];
  cube = [1, 1, 1];
  for k = 1:3, tower(k) = asStep(block(blue, cube, 0, -2, k - 1, 0)); end
  state = initialTaskState(tower, []);
  state.known = [block(red, cube, 0, -0.2, 1, 0), block(red, cube, 3, -0.2, 1, 0)];
  check(isequal([uncoveringMoves(state, 1:2, robotEye()).block], 1), 'what the building would hide is uncovered');
  state.known(3) = block(red, cube, 0, -0.2, 0, 0);
  check(isempty(uncoveringMoves(state, 1:3, robotEye())), 'unless it is known');
  state.known(2:4) = [block(blue, cube, 0, -4, 0, 0), block(blue, cube, 2, -4, 0, 0), block(blue, cube, 4, -4, 0, 0)];
  check(isempty(uncoveringMoves(state, 1:4, robotEye())), 'or nothing is missing');

  state.known = [block(red, cube, 0, -2, 0, 0), block(green, cube, -1.1, -2, 0, 0), ...
                 block(green, cube, 1.1, -2, 0, 0), block(green, cube, 0, -3.05, 0, 0), ...
                 block(blue, cube, 4, -2, 0, 0)];
  moves = clearingMoves(state, struct('block', 1, 'goal', []), 1:5);
  check(isequal([moves.block], 4), 'room for the fingers is cleared');
  check(isempty(clearingMoves(state, struct('block', 2, 'goal', []), 1:5)), 'where there is none');
  pot = block(red, [2.4, 2.4, 1.3], -4, -1, 0, 0);
  cover = block(blue, [2.6, 2.6, 0.2], -4, -1, 1.3, 0);
  places = freePlacements([], robotEye(), cover, pot, [], zeros(0, 2));
  check(numel(places) == 100, 'a large block is put aside');
  for place = places([places.yaw] == 0)
    pixels = toPixel(place.position + [-1.3, -1.3, 0.1; -1.3, 1.3, 0.1; 1.3, -1.3, 0.1; 1.3, 1.3, 0.1], robotEye());
    check(all(all(pixels > 0 & pixels < [640, 480])), 'where the eye sees all of it');
  end
  none = [proposeMoves(initialTaskState(tower, []), 1, zeros(1, 0)), uncoveringMoves(state, [], robotEye())];
  check(isempty(clearingMoves(state, none, 1:5)), 'and nothing without moves');
end

function check_resting()
  plank = newBlock([1, 0, 0], [3, 1, 0.5], [0, 0, 0], 0);
  cases = {[0, 0, 30], [3, 1, 0.5], 30; [90, 0, 30], [3, 0.5, 1], 30; [0, -90, 20], [1, 0.5, 3], 110; ...
           [45, 0, 0], [3, 1, 0.5], 0};
  for k = 1:size(cases, 1)
    [sides, yaw] = restingAt(plank, [1, 2, 3, cases{k, 1}]);
    check(isequal(sides, cases{k, 2}) && abs(yaw * 180 / pi - cases{k, 3}) < 1e-9, ...
          'an object on its side looks like another block');
  end
end

function check_failures()
  there = block([1, 0, 0], [1, 1, 1], 3, -2, 0, 0);
  goal = block([1, 0, 0], [1, 1, 1], 0, -2, 0, 0);
  state = initialTaskState(asStep(goal), []);
  state.known = goal;
  state.grasp = struct('position', there.position, 'arm', 1, 'yaw', 0.5);
  state = rememberFailure(state, {struct('kind', 'grasp'), struct('kind', 'follow'), struct('kind', 'open')});
  check(isempty(state.known), 'after a failed grasp the block is not where it was to go');
  check(isequal(state.failures, state.grasp), 'and the grasp is remembered');
  wide = block([0, 0, 1], [3, 2, 1], 0, -2, 0, 0);
  [~, reason] = planPickAndPlace(struct('opening', 2), wide, wide, noBlocks(), [], []);
  check(strcmp(reason, 'it is wider than the gripper opens'), 'a block that is too wide is not taken');
end

function step = asStep(it)
  step = newStep(it, 'step');
end

try
  check_perception();
  check_depth();
  check_forms();
  check_noise();
  check_clearance();
  check_inference();
  check_unstacking();
  check_container();
  check_lid();
  check_dragging();
  check_planning();
  check_site();
  check_clearing();
  check_resting();
  check_failures();
catch err
  fprintf('%s\n', err.message);
  exit(1);
end
fprintf('ok\n');
exit(0);
