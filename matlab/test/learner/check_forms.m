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
  check(isempty(unexplainedPoints(noBlocks(), 0 * heights, eye)), 'an empty table is explained');
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
