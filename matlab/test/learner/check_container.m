function check_container()
% A blue cube is put into a box whose floor is 0.2 high. Then the box is detected elsewhere, rotated.
  brown = [0.5, 0.3, 0.2]; blue = [0, 0, 1];
  cube = block(blue, [1, 1, 1], 3, -3, 0, 0);
  [folder, remove] = newRecording({pictureOf([emptyBox(brown, -1, -1, 0), cube])});
  write(folder, '0.txt', {'0,create,Case,shape,box', '0,create,Blue,shape,block', ...
                          '0,move,Case,-1.0,-1.0,0.45,0.0,0.0,0.0', ...
                          '0,move,Blue,3.0,-3.0,0.5,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Blue', '2,release,LeftHand', ...
                          '2,move,Blue,0.5,-1.3,0.7,0.0,0.0,0.0'});
  [steps, container] = inferTask(readDemonstration(folder), []);
  check(norm(container.position - [-1, -1, 0.45]) < 0.03, 'the box is measured where it stands');
  check(max(abs(container.size - [5, 2.6, 0.9])) < 0.05, 'with its size');
  check(abs(container.floor - 0.2) < 1e-9, 'the height of its content determines that of its floor');

  red = [1, 0, 0];
  [other, remove_other] = newRecording({pictureOf([emptyBox(brown, -1, -1, 0), emptyBox(brown, -6, -1, pi / 2), cube, ...
                                                   block(red, [1, 1, 1], 5, -3, 0, 0)])});
  write(other, '0.txt', {'0,create,Case,shape,box', '0,create,Blue,shape,block', '0,create,Other,shape,box', ...
                         '0,create,Red,shape,block', '0,move,Case,-1.0,-1.0,0.45,0.0,0.0,0.0', ...
                         '0,move,Blue,3.0,-3.0,0.5,0.0,0.0,0.0', '0,move,Other,-6.0,-1.0,0.45,0.0,0.0,90.0', ...
                         '0,move,Red,5.0,-3.0,0.5,0.0,0.0,0.0'});
  write(other, '1.txt', {'1,grasp,LeftHand,Blue', '2,release,LeftHand', '2,move,Blue,0.5,-1.3,0.7,0.0,0.0,0.0', ...
                         '3,grasp,LeftHand,Red', '4,release,LeftHand', '4,move,Red,-6.0,-0.5,0.8,0.0,0.0,0.0'});
  [two, boxes] = inferTask(readDemonstration(other), []);
  check(isequal({boxes.name}, {'Case', 'Other'}) && max(abs([boxes.floor] - [0.2, 0.3])) < 1e-9, 'there may be two boxes');
  [hidden, remove_hidden] = newRecording({pictureOf([emptyBox(brown, -1, -1, 0), cube, ...
                                                     block([0.1, 0.1, 0.1], [1.5, 1.5, 3], -3, -2, 0, 0)])});
  for name = {'0.txt', '1.txt'}, copyfile(fullfile(folder, name{1}), hidden); end
  [~, box] = inferTask(readDemonstration(hidden), []);
  check(max(abs([box.position, box.size] - [-1, -1, 0.45, 5, 2.6, 0.9])) < 0.06, 'an arm may hide a corner');
  picture = pictureOf([emptyBox(brown, -1, -1, 0.3), emptyBox(brown, -6, -2, pi / 2)]);
  [two, found] = placeInContainers(two, boxes, noBlocks(), picture, robotEye());
  check(max(abs([found.position] - [-1, -1, 0.45, -6, -2, 0.45])) < 0.03, 'each is found where it is');
  check(norm(two(1).position(1:2) - [-1, -1] - rotated([1.5, -0.3], 0.3)) < 0.05, 'each thing goes with its box');
  check(norm(two(2).position(1:2) - [-6, -1.5]) < 0.05, 'also the other one');

  there = block(blue, [1, 1, 1], 0.9, -1.6, 0.2, 0.3);
  picture = pictureOf([emptyBox(brown, 1, -2, 0.3), there]);
  [found, turn] = detectContainer(picture, robotEye(), container);
  check(norm(found.position - [1, -2, 0.45]) < 0.03, 'the box is detected elsewhere');
  check(abs(turn - 0.3) < 0.02, 'with its rotation');
  seen = detectBlocks(picture, robotEye(), steps, found);
  check(abs(seen.position(3) - 0.7) < 1e-9, 'a block in it lies on its floor');
  walls = containerWalls(found);
  there.position = found.position + [0, 0, 0.25];
  check(isequal(graspYaws(there, walls), there.yaw + [pi / 2, -pi / 2, 0, pi]), ...
        'there is room for the fingers in the middle');
  there.position = found.position + [1.7 * [cos(0.3), sin(0.3)], 0.25];
  check(isequal(graspYaws(there, walls), there.yaw + [pi / 2, -pi / 2]), 'but not at the end');
end
