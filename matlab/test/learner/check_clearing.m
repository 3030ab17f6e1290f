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
