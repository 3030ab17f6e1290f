function check_dragging()
% A door with a post on it is dragged by 2 and 1; another post of the same color stays.
  yellow = [0.9, 0.7, 0.1]; red = [0.7, 0.3, 0.2];
  door = @(x, y) [block(yellow, [3, 2, 2], x, y, 0, 0.5), block(red, [1, 0.6, 1.2], x, y, 2, 0.5)];
  other = block(red, [1, 0.6, 1.2], 4, -4, 0, 0);
  [folder, remove] = newRecording({pictureOf([other, door(-2, -3)]), pictureOf([other, door(0, -2)])});
  write(folder, '0.txt', {'0,create,Door,shape,composite', '0,move,Door,-2.2,-3.1,1.9,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Door', '1,move,Door,-0.2,-2.1,1.9,0.0,0.0,0.0', ...
                          '1,release,LeftHand'});
  [step, containers] = inferTask(readDemonstration(folder), []);
  check(isempty(containers), 'there is no container');
  check(norm(step.displacement - [2, 1]) < 1e-9, 'it was dragged');
  check(abs(step.position(3) + step.size(3) / 2 - 3.2) < 0.05, 'its displacement in the pictures determines the height');
  check(norm(step.position(1:2) - [-2, -3]) < 0.03 && max(abs(step.size(1:2) - [1, 0.6])) < 0.03, ...
        'its post is the handle');

  for away = [0.1, 0.15]
    it = block(step.color, step.size, step.position(1) - away / sqrt(5), step.position(2) + 2 * away / sqrt(5), 0, step.yaw);
    check(isInPlace(it, step) == (away == 0.1), 'it may end as far to the side as its direction is uncertain');
  end

  state = initialTaskState(step, []);
  state.known = block(step.color, step.size, 3, -2, 0, 0.8);
  state = chooseSite(state, [], [], []);
  turn = [cos(0.3), sin(0.3); -sin(0.3), cos(0.3)];
  check(state.hasSite && norm(state.steps.position(1:2) - [3, -2] - [2, 1] * turn) < 0.01, ...
        'the displacement of a rotated door is rotated');
  state = initialTaskState(step, []);
  [state, problem] = chooseSite(state, [], [], []);
  check(~state.hasSite && ~isempty(strfind(problem, '0 visible objects look like')), ...
        'an invisible door is not dragged');
  delete(fullfile(folder, 'rgb', '1.png'));
  message = '';
  try
    inferTask(readDemonstration(folder), []);
  catch problem
    message = problem.message;
  end
  check(~isempty(strfind(message, 'the handle of Door')), 'an invisible handle is reported');
end
