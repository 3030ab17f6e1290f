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
