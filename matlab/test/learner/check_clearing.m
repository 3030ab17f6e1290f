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
  moves = clearingMoves(state, newMove(1), 1:5);
  check(isequal([moves.block], 4), 'room for the fingers is cleared');
  check(isempty(clearingMoves(state, newMove(2), 1:5)), 'where there is none');
  % What touches another is taken before the building leaves no room beside it.
  touching = [block(green, cube, 0, -0.7, 0, 0), block(green, cube, 1, -0.7, 0, 0)];
  state = initialTaskState([asStep(block(red, cube, 0, -1.95, 0, pi / 2)), asStep(block(green, cube, -3, -4, 0, 0))], []);
  state.known = touching;
  check(isequal([proposeMoves(state, 1, 1:2).block], 1), 'what will be blocked is taken first');
  check(isempty(proposeMoves(state, 1, 1)), 'unless fingers fit in on its other sides');
  state.asides = struct('step', 1, 'place', touching(1));
  check(isempty(proposeMoves(state, 1, 1:2)), 'or it was put there for this step');
  check(proposeMoves(state, 2, 1:2)(1).block == 1, 'not for another one');
  state = initialTaskState(tower, []);
  pot = block(red, [2.4, 2.4, 1.3], -4, -1, 0, 0);
  cover = block(blue, [2.6, 2.6, 0.2], -4, -1, 1.3, 0);
  places = freePlacements([], robotEye(), cover, pot, [], zeros(0, 2));
  check(numel(places) == 100, 'a large block is put aside');
  for place = places([places.yaw] == 0)
    pixels = toPixel(place.position + [-1.3, -1.3, 0.1; -1.3, 1.3, 0.1; 1.3, -1.3, 0.1; 1.3, 1.3, 0.1], robotEye());
    check(all(all(pixels > 0 & pixels < [640, 480])), 'where the eye sees all of it');
  end
  cube_on = @(eye, y) freePlacements([], eye, block(green, cube, 0, y, 0, 0), noBlocks(), [], zeros(0, 2));
  behind = robotEye();
  behind.pose(2, 4) = behind.pose(2, 4) - 4;
  behind.table = [20, 20];
  check(isequal(vertcat(cube_on(behind, -6).position), vertcat(cube_on(robotEye(), -2).position) - [0, 4, 0]), ...
        'places are as far from the near edge of a deep table');
  narrow = robotEye();
  narrow.table = [6, 12];
  check(max(abs(vertcat(cube_on(narrow, -2).position)(:, 1))) == 2.5, 'and on a narrow one');
  none = [proposeMoves(initialTaskState(tower, []), 1, zeros(1, 0)), uncoveringMoves(state, [], robotEye())];
  check(isempty(clearingMoves(state, none, 1:5)), 'and nothing without moves');
end
