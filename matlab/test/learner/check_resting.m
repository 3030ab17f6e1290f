function check_resting()
  plank = newBlock([1, 0, 0], [3, 1, 0.5], [0, 0, 0], 0);
  cases = {[0, 0, 30], [3, 1, 0.5], 30; [90, 0, 30], [3, 0.5, 1], 30; [0, -90, 20], [1, 0.5, 3], 110; ...
           [45, 0, 0], [3, 1, 0.5], 0};
  for k = 1:size(cases, 1)
    [sides, yaw] = restingAt(plank, [1, 2, 3, cases{k, 1}]);
    check(isequal(sides, cases{k, 2}) && abs(yaw * 180 / pi - cases{k, 3}) < 1e-9, ...
          'an object on its side looks like another block');
  end

  flat = [3, 1, 0.5]; side = [3, 0.5, 1];
  check(isempty(turnsBetween(flat, flat, 2)) && isequal(turnsBetween(flat, [1, 0.5, 3], 2), 2) && ...
        isequal(turnsBetween(flat, side, 2), [2, 2]), 'turns about the fingers bring a block onto any face');
  check(isnan(turnsBetween(flat, side, 0.9)) && isnan(turnsBetween(flat, [2, 1, 1], 2)), 'or they cannot');

  began = block([1, 0, 0], side, -2, -2, 0, 30 * pi / 180);
  [folder, remove] = newRecording({pictureOf(began), pictureOf(block([1, 0, 0], flat, 2, -3, 0, 0))});
  write(folder, '0.txt', {'0,create,Plank,shape,block', '0,move,Plank,-2.0,-2.0,0.5,90.0,0.0,30.0'});
  write(folder, '1.txt', {'1,grasp,AnyHand,Plank', '1,move,Plank,2.0,-3.0,0.25,0.0,0.0,0.0', '1,release,AnyHand'});
  step = inferTask(readDemonstration(folder), []);
  check(max(abs(step.size - flat)) < 0.03 && max(abs(step.startSize - side)) < 0.03 && abs(sin(step.yaw)) < 0.02, ...
        'what began on its side is laid down');

  goal = asStep(block([1, 0, 0], side, 0, -2, 0, 0));
  goal.startSize = flat;
  state = initialTaskState(goal, []);
  check(isequal(vertcat(state.unknownObjects.size), [1, 0.5, 3; 3, 1, 0.5]), 'it may lie on any face');
  moves = turningMoves(goal, plank, 1, 1.9);
  check(isequal({moves.block}, {1, 1}) && isequal({moves.turns}, {[2, 2], []}), 'it is turned if it does not look as wanted');
  there = block([1, 0, 0], side, 3, -2, 0, 0);
  check(isempty(turningMoves(goal, [plank, there], 1:2, 1.9)), 'unless another does');
end
