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

  is_top = false(480, 640);
  is_top(251:271, 271:291) = true;
  is_top(269, 273:290) = false;  % as at a corner, of which pixels show the side
  [top.row, top.column] = find(is_top);
  [~, v] = edgeTowardNadir(top, eye);
  check(ceil(v) == 272, 'a top ends where the line below it leaves it last');

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
