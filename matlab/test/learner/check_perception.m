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
