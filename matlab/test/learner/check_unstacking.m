function check_unstacking()
% A tower is taken apart. Its lower blocks, a half and a cube, are visible only later.
  cube = [1, 1, 1];
  tower = [block([1, 0, 0], [1, 1, 0.5], -2, -2, 0, 0), block([0, 1, 0], cube, -2, -2, 0.5, 0), ...
           block([0, 0, 1], cube, -2, -2, 1.5, 0)];
  apart = tower;
  for k = 1:3, apart(k).position = [2 * k - 4, -3, tower(k).size(3) / 2]; end
  [folder, remove] = newRecording({pictureOf(tower), pictureOf([tower(1:2), apart(3)]), ...
                                   pictureOf([tower(1), apart(2:3)])});
  names = {'Red', 'Green', 'Blue'};
  move = @(frame, k, position) sprintf('%d,move,%s,%g,%g,%g,0.0,0.0,0.0', frame, names{k}, position);
  lines = cellfun(@(name) ['0,create,', name, ',shape,block'], names, 'UniformOutput', false);
  for k = 1:3, lines{end + 1} = move(0, k, tower(k).position); end
  write(folder, '0.txt', lines);
  lines = {};
  for frame = 1:3
    k = 4 - frame;
    lines = [lines, {sprintf('%d,grasp,AnyHand,%s', frame, names{k}), move(frame, k, [3, 0, 4.5]), ...
                     move(frame, k, apart(k).position), sprintf('%d,release,AnyHand', frame)}];
  end
  write(folder, '1.txt', lines);
  steps = inferTask(readDemonstration(folder), []);
  check(isequal({steps.name}, {'Blue', 'Green', 'Red'}), 'the highest comes first');
  sizes = vertcat(steps.size);
  check(max(max(abs(sizes - [1, 1, 1; 1, 1, 1; 1, 1, 0.5]))) < 0.03, 'heights follow from what is below');
  check(isempty([steps.on]), 'all are put on the table');
end
