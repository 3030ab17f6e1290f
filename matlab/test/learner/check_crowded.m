function check_crowded()
% Where a table is full, and where something high, or something that touches, is beside a place.
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1];
  cube = [1, 1, 1];
  large = [1.2, 1.2, 0.8];
  high = [1.4, 1.4, 1.4];
  moved = block(red, cube, -4, -2, 0, 0);
  others = [block(blue, large, 3, -1, 0, 0.3), block(blue, [0.6, 0.6, 0.6], 0, -1, 0, 0), block(green, cube, 1, -4, 0, 0), ...
            block(blue, large, -2, -4, 0, 0), block(blue, cube, -3, 0, 0, 0), block(blue, cube, -2, -4, 0.8, 0), ...
            block(blue, cube, 12, 0, 0, 0)];
  places = placesOnOthers(moved, others, block(green, cube, -3, -2, 0, 0), robotEye());
  bottoms = arrayfun(@(it) it.position(3) - it.size(3) / 2, places);
  check(numel(bottoms) == 3 && max(abs(bottoms - [1, 1.8, 0.8])) < 1e-9, 'a block is put on the closest that no step needs');
  check(isequal(places(3).position(1:2), others(1).position(1:2)) && places(3).yaw == others(1).yaw, 'as that lies');

  step = asStep(block(red, [4, 1, 1], 0, -2, 0, 0));
  beside = [block(green, cube, 0.2, -3.7, 0, 0), block(blue, high, 0.2, -3.85, 0, 0), block(blue, high, 0, -5, 0, 0)];
  moves = movesFromPlace(step, beside, 1:3);
  check(isequal([moves.block], 2), 'what is higher than the fingers is taken away from beside a place');
  beside(4) = block(green, cube, 0.2, -3.85, 1.4, 0);
  check(isempty(movesFromPlace(step, beside, 1:4)), 'what carries others waits');

  goal = block(red, [2, 1, 1], 0, -2, 0, pi / 2);
  right = block(green, cube, 0, -0.49, 0, 0);
  near = @(away, expected) check(norm(away - expected) < 1e-9, 'what touches others is lowered beside them, where there is room');
  near(besideTouching(goal, right), [0, -0.04]);
  near(besideTouching(goal, [right, block(green, cube, -1.01, -2.3, 0, 0)]), [0.04, -0.04]);
  near(besideTouching(goal, [right, block(green, cube, 0, -3.51, 0, 0)]), [0, 0]);
  near(besideTouching(goal, block(green, cube, 0, -0.49, 1, 0)), [0, 0]);
  near(besideTouching(goal, noBlocks()), [0, 0]);
end
