% Tests how the learner sees the pictures of a demonstration, and reconstructs it from them, without the simulator:
%
%   octave-cli matlab/test/watch_test.m
%
% prints "ok" or the first wrong claim, and exits with 0 or 1.
here = fileparts(mfilename('fullpath'));
addpath(genpath(fullfile(here, '..', 'learner')), fullfile(here, 'learner'));

function block = blockAt(color, size, position, yaw)
  block = struct('color', color, 'size', size, 'position', position, 'yaw', yaw);
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
  kinds = kindsIn(tops, picture, eye, table);
  for wanted = [plank, red]
    kind = kinds(arrayfun(@(kind) sameColor(kind.color, wanted.color), kinds));
    check(max(abs(kind.size - wanted.size)) < 0.06, 'the size of a single block is measured');
  end

  % A block with a hidden foot cannot be measured; a block of an unknown color has a known size.
  blue = blockAt([0, 0, 1], [1, 1, 1], [1.5, 0, 1.5], 0.1);
  picture = draw([plank, blockAt([0, 1, 0], [1, 1, 1], [1.5, 0, 0.5], 0), blue], eye);
  tops = segmentTopFaces(picture, table);
  check(~any(arrayfun(@(kind) sameColor(kind.color, plank.color), kindsIn(tops, picture, eye, table))), ...
        'the height of a partly hidden block is not guessed');
  top = tops(arrayfun(@(top) sameColor(top.color, blue.color), tops));
  [kinds.color] = deal(blue.color);
  block = fitBlocks(top.row, top.column, eye, kinds, [], @(block) true, repmat({0:5}, 1, numel(kinds)));
  check(norm(block.position - blue.position) < 0.05, 'an upper block is located');
end

function kinds = kindsIn(tops, picture, eye, table)
% Returns the kinds of the blocks that lie by themselves on the table: as from blockKinds.
  kinds = blockKinds(noBlocks(), []);
  for top = tops
    for block = measureBlock(top, picture, eye, table)
      kinds = [kinds, blockKinds(block, block.color)];
    end
  end
end

try
  check_regions();
  check_picture();
  check_watching();
  disp('ok');
catch problem
  disp(problem.message);
  for k = 1:numel(problem.stack), printf('  %s, line %d\n', problem.stack(k).name, problem.stack(k).line); end
  exit(1);
end
