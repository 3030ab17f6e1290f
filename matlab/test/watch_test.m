% Tests how the learner reconstructs a demonstration from pictures, without the simulator:
%
%   octave-cli matlab/test/watch_test.m
%
% prints "ok" or the first wrong claim, and exits with 0 or 1.
here = fileparts(mfilename('fullpath'));
addpath(fullfile(here, '..', 'learner'));

function check(is_true, claim)
  if ~is_true, error('not so: %s', claim); end
end

function block = blockAt(color, size, position, yaw)
  block = struct('color', color, 'size', size, 'position', position, 'yaw', yaw, 'pixels', 1000);
end

function eye = someEye()
  pitch = -2.5;  % rad; it looks down at the table's middle
  eye.intrinsics = [420, 0, 320; 0, 420, 240; 0, 0, 1];
  eye.pose = [1, 0, 0, 0; 0, cos(pitch), -sin(pitch), -6; 0, sin(pitch), cos(pitch), 11.5; 0, 0, 0, 1];
end

function picture = draw(blocks, eye)
% Renders a white table on black, and blocks, the rear ones first: tops have the true color, sides are darker.
  picture = zeros(480, 640, 3);
  picture(60:end, :, :) = 1;
  for block = blocks
    c = cos(block.yaw);
    s = sin(block.yaw);
    corners = [1, -1, -1, 1; 1, 1, -1, -1]' / 2 .* block.size(1:2) * [c, s; -s, c] + block.position(1:2);
    low = block.position(3) - block.size(3) / 2;
    high = block.position(3) + block.size(3) / 2;
    [~, far] = sort(-corners(:, 2) - corners([2:4, 1], 2));
    for k = far'
      next = 1 + mod(k, 4);
      side = [corners([k, next], :), [low; low]; corners([next, k], :), [high; high]];
      picture = fill(picture, side, (0.5 + 0.05 * k) * block.color, eye);
    end
    picture = fill(picture, [corners, repmat(high, 4, 1)], block.color, eye);
  end
  picture = round(255 * picture) / 255;
end

function picture = fill(picture, points, color, eye)
  for k = 1:4, corner(k, :) = toPixel(points(k, :), eye); end
  [column, row] = meshgrid((1:640) - 0.5, (1:480) - 0.5);
  inside = inpolygon(column, row, corner(:, 1), corner(:, 2));
  for channel = 1:3
    layer = picture(:, :, channel);
    layer(inside) = color(channel);
    picture(:, :, channel) = layer;
  end
end

function check_regions()
  number = labelRegions([5, 5, 0; 0, 3, 3; 5, 0, 3; 5, 5, 3]);
  check(isequal(sort(unique(number(:)))', 0:3) && all(number([3, 4, 8]) == number(3)), ...
        'pixels of one region are equal and connected');
  check(number(1) ~= number(3) && number(1, 2) ~= number(2, 2), 'different pixels form different regions');
  check(isequal(labelRegions(false(2)), zeros(2)), 'an empty mask has no regions');
end

function check_picture()
  eye = someEye();
  red = blockAt([1, 0, 0], [1, 1, 1], [-2, -1, 0.5], 0.4);
  plank = blockAt([0.3, 0.2, 0.1], [4, 1, 1.5], [2, 1.5, 0.75], -0.2);
  picture = draw([plank, red], eye);
  table = tableColor(picture);
  tops = segmentTopFaces(picture, table);
  check(numel(tops) == 2, 'sides are not taken for tops');
  kinds = learnBlockKinds(tops, picture, eye, table);
  for wanted = [plank, red]
    kind = kinds(arrayfun(@(kind) sameColor(kind.color, wanted.color), kinds));
    check(max(abs(kind.size - wanted.size)) < 0.06, 'the size of a single block is measured');
  end

  % A block with a hidden foot cannot be measured; a block of an unknown color has a known size.
  blue = blockAt([0, 0, 1], [1, 1, 1], [1.5, 0, 1.5], 0.1);
  picture = draw([plank, blockAt([0, 1, 0], [1, 1, 1], [1.5, 0, 0.5], 0), blue], eye);
  tops = segmentTopFaces(picture, table);
  check(~any(arrayfun(@(kind) sameColor(kind.color, plank.color), learnBlockKinds(tops, picture, eye, table))), ...
        'the height of a partly hidden block is not guessed');
  top = tops(arrayfun(@(top) sameColor(top.color, blue.color), tops));
  [kinds.color] = deal(blue.color);
  block = fitBlocks(top.row, top.column, eye, kinds, [], @(block) true, repmat({0:5}, 1, numel(kinds)));
  check(norm(block.position - blue.position) < 0.05, 'an upper block is located');
end

function check_tracking()
  unit = [1, 1, 1];
  red = @(position) blockAt([1, 0, 0], unit, position, 0);
  blue = @(position) blockAt([0, 0, 1], unit, position, 0);
  no = @(block) false;
  yes = @(block) true;
  objects = trackBlocks(trackBlocks(), [red([-3, 0, 0.5]), red([3, 0, 0.5]), blue([0, 0, 0.5])], no, no);
  check(numel(objects) == 3 && ~any([objects.placed]), 'objects in the first picture have not moved');

  % The blue block is held, then put onto the left red one; the hand occludes the right red one.
  objects = trackBlocks(objects, [red([-3, 0, 0.5]), blue([-3, 0, 2.5])], no, no);
  check(objects(3).position(3) == 0.5, 'a held block keeps its old place');
  objects = trackBlocks(objects, blue([-3, 0, 1.5]), yes, no);
  check(objects(3).position(3) == 1.5 && objects(3).placed == 1, 'a block on another one was moved');

  % A red block at a new place: the left one was closer, but the blue one lies on it.
  objects = trackBlocks(objects, [blue([-3, 0, 1.5]), red([-1.5, 0, 0.5])], no, no);
  check(objects(2).position(1) == -1.5 && objects(1).position(1) == -3, 'a covered block cannot have moved');
  check(objects(2).placed == 2 && numel(objects) == 3, 'the uncovered one has');

  % A block that was hidden so far has not moved; one whose place was empty has.
  green = @(x) blockAt([0, 1, 0], unit, [x, 2, 0.5], 0);
  objects = trackBlocks(objects, green(0), no, @(block) block.position(1) > 1);
  objects = trackBlocks(objects, [green(0), green(2)], no, @(block) block.position(1) > 1);
  check(isequal([objects(4:5).placed], [0, 3]), 'a new block was moved if its place was empty');

  % A partly hidden block stays where it was entirely visible.
  part = green(2.2);
  part.pixels = 900;
  objects = trackBlocks(objects, part, no, no);
  check(objects(5).position(1) == 2, 'a partly hidden block does not move');
end

try
  check_regions();
  check_picture();
  check_tracking();
  disp('ok');
catch problem
  disp(problem.message);
  for k = 1:numel(problem.stack), printf('  %s, line %d\n', problem.stack(k).name, problem.stack(k).line); end
  exit(1);
end
