function check_meant()
% One of several objects that look the same is told by what it began on: red cubes on two blue plates, on a green one,
% and on the table.
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1];
  plate = [2, 2, 0.2];
  looks = [block(blue, plate, -3, 1, 0, 0), block(blue, plate, 3, 1, 0, 0), block(green, plate, 0, 3, 0, 0), ...
           block(red, [1, 1, 1], -3, 1, 0.2, 0), block(red, [1, 1, 1], 3, 1, 0.2, 0), ...
           block(red, [1, 1, 1], 0, 3, 0.2, 0), block(red, [1, 1, 1], 0, 0, 0, 0)];
  demo.ids = {'Left', 'Right', 'Green', 'A', 'B', 'C', 'D'};
  demo.start = [vertcat(looks.position), zeros(7, 3)];
  demo.final = demo.start;
  for n = 4:7
    steps(n - 3) = asStep(looks(n));
    steps(n - 3).beganOn = startSupport(demo, n, steps(n - 3), looks);
  end
  names = cellfun(@(it) it.name, {steps.beganOn}, 'UniformOutput', false);
  check(isequal(names, {'Left', 'Right', 'Green', 'the table'}), 'what it began on tells an object from others');
  check(isempty(startSupport(demo, 4, steps(1), looks([1:4, 1, 2, 3]))), 'but not where no other looks the same');

  % Here the plates are elsewhere, the right one nearer.
  known = [block(blue, plate, 2, -4, 0, 0), block(blue, plate, -4, -2, 0, 0), block(green, plate, -1, -1, 0, 0), ...
           block(red, [1, 1, 1], 2, -4, 0.2, 0), block(red, [1, 1, 1], -4, -2, 0.2, 0), ...
           block(red, [1, 1, 1], -1, -1, 0.2, 0), block(red, [1, 1, 1], 5, -1, 0, 0)];
  check(isequal(meantBlocks(steps, known)(:, 1)', [-4, 2, -1, 5]), 'also in another scene');
  steps(1).position = [0, -4.5, 0.5];
  state = initialTaskState(steps(1), []);
  state.known = known;
  state.meant = meantBlocks(state.steps, known);
  check(isequal(carried(state), -4), 'the meant one is carried');
  state.known(5).position = [6, -5, 0.5];
  state.meant = [6, -5, 0.5];
  check(isequal(carried(state), 6), 'also after it was put aside');
  state.known(5) = [];
  check(numel(carried(state)) == 3, 'or any other if it was lost');
end

function x = carried(state)
  moves = proposeMoves(state, 1, 1:numel(state.known));
  moves = moves(~cellfun(@isempty, {moves.goal}));
  x = arrayfun(@(move) state.known(move.block).position(1), moves);
end
