function check_outlines()
% An L is lifted and turned.
  red = [1, 0, 0];
  eye = robotEye();
  [folder, remove] = newRecording({pictureOf(anAngle(2, -3, 0, 0, 1)), pictureOf(anAngle(1, -2.5, 0.2, 1.5, 1))});
  write(folder, '0.txt', {'0,create,Angle,shape,composite', '0,move,Angle,2.0,-3.0,0.3,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Angle', sprintf('1,move,Angle,1.0,-2.5,1.8,0.0,0.0,%.12f', 0.2 * 180 / pi)});
  write(folder, '2.txt', {'2,release,LeftHand'});
  kind = measureObjects(readDemonstration(folder), 1);
  check(abs(kind.outline.area - 1.62) < 0.05 && kind.outline.fold == 1, 'a piece is measured by its outline in two pictures');
  check(max(abs(kind.size - [2.4, 1.6, 0.6])) < 0.06, 'it fills a rectangle around its center');
  check(abs(kind.knob.size(2) - 0.6) < 0.05 && ~hasEqualSides(kind.knob), 'it is held where it is narrow');

  kind.position = [0, 0, 0.3];
  held = arrayfun(@(it) heldPart(it), heldAnyhow(kind));
  legs = vertcat(held(arrayfun(@(it) it.size(2) < 0.65, held)).position);
  check(numel(held) > 3 && any(legs(:, 1) < 0) && any(legs(:, 1) > 0), 'or by its other leg, where the first one is out of reach');

  for yaw = [-1.2, 0.3, 0.3 + pi]
    [picture, heights] = pictureOf(anAngle(-2, -3, yaw, 0, 1));
    found = detectBlocks(picture, eye, kind, [], heights);
    check(numel(found) == 1 && max(abs(found.position - [-2, -3, 0.3])) < 0.03, 'a piece is recognized at each yaw');
    check(abs(yawDifference(found, yaw)) < 0.02 && isSameKind(found, kind), 'which its outline tells');
    check(isempty(detectUnknownObjects(picture, eye, found, heights)), 'it is no unknown object');
  end
  [picture, heights] = pictureOf(anAngle(-2, -3, 0, 0, -1));
  check(isempty(detectBlocks(picture, eye, kind, [], heights)), 'its mirror image is another piece');
  check(~isSameKind(block(red, kind.size, -2, -3, 0, 0), kind), 'and so is a rectangle');

  post = block([0, 0, 1], [0.6, 0.6, 1], -1.69, -2.77, 0, 0);
  there = kind;
  there.position = [-2, -3, 0.3];
  there.yaw = 0;
  [picture, heights] = pictureOf([anAngle(-2, -3, 0, 0, 1), post]);
  verdict = verdictsOn(there, detectBlocks(picture, eye, [kind, post], [], heights), picture, eye, heights, 0.07);
  check(strcmp(verdict.word, 'hidden') && isempty(verdict.found), 'what stands in the corner of a piece is not in its place');
  [picture, heights] = pictureOf(post);
  verdict = verdictsOn(there, detectBlocks(picture, eye, [kind, post], [], heights), picture, eye, heights, 0.07);
  check(strcmp(verdict.word, 'contradicted'), 'a piece is gone where the table is seen');

  [x, y] = meshgrid(-0.99:0.02:1);
  hexagon = abs(y) < 0.5 * sqrt(3) & sqrt(3) * abs(x) + abs(y) < sqrt(3);
  is_in = {x > -0.4 & x + sqrt(3) * abs(y) < 0.8, abs(x) < 0.3 | abs(y) < 0.3, hexagon, abs(hypot(x, y) - 0.7) < 0.2};
  fold = [3, 4, 6, 0];
  for k = 1:4
    points = [x(is_in{k}), y(is_in{k})];
    area = repmat(0.0004, rows(points), 1);
    kind.outline = outlineOf(points(:, 1), points(:, 2), area);
    kind.yaw = 0;
    check(kind.outline.fold == fold(k), 'a triangle looks the same after a third of a turn, a cross after a quarter');
    turn = 1;
    if fold(k) > 0, turn = 2 * pi / fold(k); end
    check(abs(yawDifference(kind, turn)) < 1e-9, 'a ring after any');
    points = rotated(points, turn);
    check(sameOutline(kind.outline, outlineOf(points(:, 1), points(:, 2), area)), 'and is then the same');
  end
  disc = hypot(x, y) < 0.2;
  check(isPolygon(x(hexagon), y(hexagon), repmat(0.0004, nnz(hexagon), 1)), 'a hexagon is no disc');
  check(~isPolygon(x(disc), y(disc), repmat(0.0004, nnz(disc), 1)), 'a small disc is one');
  ring = block(red, [1.8, 1.8, 0.5], 2, -1, 0, 0);
  ring.outline = kind.outline;
  post = block([0, 0, 1], [0.5, 0.5, 1], 2, -1, 0, 0);
  check(isAround(ring, post) && ~isAround(post, ring), 'a ring is around what is in its hole');
  far = block([0, 0, 1], [0.5, 0.5, 1], 4, -1, 0, 0);
  check(~isAround(ring, far), 'not around what is beside it');
  check(isPlacedBy(ring, post) && ~isPlacedBy(ring, far), 'that tells where it is');
  grip = gripsOf(points(:, 1), points(:, 2), 0.02, red, 0.5)(1);
  check(abs(grip.size(2) - 1.8) < 0.05 && norm(grip.position) < 0.05, 'a ring is held around its middle');
end

function blocks = anAngle(x, y, yaw, bottom, mirror)
% Returns two red blocks that form an L, the far one first.
  at = [x, y] + rotated([-0.3 * mirror, 0.35; 0.3 * mirror, -0.4], yaw);
  blocks = [block([1, 0, 0], [0.6, 0.9, 0.6], at(1, 1), at(1, 2), bottom, yaw), ...
            block([1, 0, 0], [1.8, 0.6, 0.6], at(2, 1), at(2, 2), bottom, yaw)];
  [~, order] = sort(-at(:, 2));
  blocks = blocks(order);
end
