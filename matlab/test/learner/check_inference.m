function check_inference()
% A plank stays; a red cube is put on it, another stays, and a blue cube is moved twice.
  names = {'Plank', 'Red', 'Other', 'Blue'};
  objects = [block([0, 1, 0], [1, 4, 1], -2, -2, 0, 0.2), block([1, 0, 0], [1, 1, 1], 3, -3, 0, 0), ...
             block([1, 0, 0], [1, 1, 1], 3, -1, 0, 0), block([0, 0, 1], [1, 1, 1], 1, -4, 0, 0)];
  [folder, remove] = newRecording({pictureOf(objects)});
  lines = {};
  for i = 1:4, lines{end + 1} = sprintf('0,create,%s,shape,block', names{i}); end
  for i = 1:4
    lines{end + 1} = sprintf('0,move,%s,%.3f,%.3f,%.3f,0.0,-0.0,%.12f', names{i}, ...
                             objects(i).position, objects(i).yaw * 180 / pi);
  end
  write(folder, '0.txt', lines);
  write(folder, '1.txt', {'3,grasp,LeftHand,Blue', '5,move,Blue,0.0,-4.0,2.0,0.0,0.0,0.0', ...
                          '6,release,LeftHand', '6,move,Blue,0.0,-4.0,0.5,0.0,0.0,0.0'});
  write(folder, '2.txt', {'7,grasp,AnyHand,Red', '9,release,AnyHand', ...
                          '9,move,Red,-2.0,-1.5,1.5,1.0E-4,0.0,95.0', '10,grasp,LeftHand,Blue', ...
                          '11,release,LeftHand', '11,move,Blue,-2.0,-1.5,2.5,0.0,0.0,0.0'});

  demo = readDemonstration(folder);
  steps = inferTask(demo, struct('object', {'Blue'}, 'properties', {{'size'}}));
  check(isequal({steps.name}, {'Plank', 'Red', 'Blue'}), 'steps come in the order of building');
  check(isequal({steps.on}, {[], 1, 2}), 'each stands on the one before');
  check(max(abs(steps(1).size - [4, 1, 1])) < 0.03, 'the longer side of the plank comes first');
  check(abs(yawDifference(steps(1), 0.2 + pi / 2)) < 1e-9, 'and determines its yaw');
  check(norm(steps(2).position - [-2, -1.5, 1.5]) < 1e-9, 'the last move determines the position');
  check(abs(steps(2).yaw - 95 * pi / 180) < 1e-9, 'and the yaw');
  check(max(abs(steps(2).color - [1, 0, 0])) < 0.01, 'the color is read from the picture');
  check(isequal([steps.stays], [true, false, false]), 'what was not moved stays');
  check(isempty(steps(3).color), 'the demonstrator specified that only the size of Blue matters');

  steps = inferTask(demo, struct('object', {'Red'}, 'properties', {{'color', 'size', 'order'}}));
  check(isequal({steps.after}, {[], [], 2}), 'an order that matters is kept');

  [~, containers, appearances] = inferTask(demo, []);
  [keyframes, goal] = explain(demo, appearances, containers);
  check(isequal({keyframes.deed}, {'', 'LeftHand carries Blue', 'AnyHand carries Red', 'LeftHand carries Blue'}), ...
        'each carry is a deed');
  check(isequal([keyframes.isMeans], [false, true, false, false]), 'what is not kept is a means');
  check(any(strcmp(keyframes(3).facts, 'on Blue table')), 'facts are those before the next deed');
  check(isequal(goal, {'on Red Plank', 'place Red Plank 0.10 0.49 84', 'on Blue Red', ...
                       'place Blue Red 0.00 0.00 -95'}), 'the goal is what is made and kept');
  cut = struct('word', 'use', 'fields', {{'LeftHand', 'Knife', 'cut', 'String between link 1 and 2'}});
  world = worldAfter(cut, struct('held', struct(), 'names', {{}}, 'values', {{}}), {});
  check(isequal([world.names, world.values], {'cut String', 'Knife'}), 'what was cut is a fact');

  arm = block([0.1, 0.1, 0.1], [0.7, 0.9, 1], 3, -3, 0, 0);
  [hidden, remove_hidden] = newRecording({pictureOf(arm), pictureOf(block([1, 0, 0], [1, 1, 1], -3, -3, 1, 0)), ...
                                          pictureOf(block([1, 0, 0], [1, 1, 1], -3, -3, 0, 0))});
  write(hidden, '0.txt', {'0,create,Red,shape,block', '0,move,Red,3.0,-3.0,0.5,0.0,0.0,0.0'});
  write(hidden, '1.txt', {'1,grasp,LeftHand,Red', '1,move,Red,-3.0,-3.0,1.5,0.0,0.0,0.0', ...
                          '2,move,Red,-3.0,-3.0,0.5,0.0,0.0,0.0', '3,release,LeftHand'});
  red = measureObjects(readDemonstration(hidden), 1);
  check(max(abs([red.color, red.size] - [1, 0, 0, 1, 1, 1])) < 0.03, 'an arm over an object is not taken for it');
  check(isempty(demo.unclear), 'all was released');
  write(folder, '3.txt', {'12,grasp,RightHand,Other'});
  check(isequal(readDemonstration(folder).unclear, {'why Other is still held at the end'}), 'now something is held at the end');
  write(folder, '3.txt', {'12,grasp,RightHand,Blue'});
  steps = inferTask(readDemonstration(folder), []);
  check(isequal({steps.name}, {'Plank', 'Red'}), 'the rest is done');

  delete(fullfile(folder, 'rgb', '0.png'));
  message = '';
  try
    inferTask(demo, []);
  catch problem
    message = problem.message;
  end
  check(~isempty(strfind(message, 'no picture of the demonstration shows Red')), ...
        'an invisible object is reported');

  file = fopen(fullfile(folder, 'demo.json'), 'w');
  fputs(file, '{"meters_per_unit": 0.1, "eye": null}');
  fclose(file);
  try
    readDemonstration(folder);
  catch problem
    message = problem.message;
  end
  check(~isempty(strfind(message, 'has no pictures')), 'a recording without pictures is reported');
end
