function check_uses()
% A knife with a blue tip cuts a string, and is put back.
  green = [0, 1, 0]; brown = [0.5, 0.3, 0.2]; red = [1, 0, 0];
  eye = robotEye();
  string = [block(green, [0.2, 3, 0.2], 1, -2, 1, 0), block(brown, [0.5, 0.5, 1], 1, -0.5, 0, 0)];
  [folder, remove] = newRecording({pictureOf([knife(-2, -3, 0), string]), pictureOf([knife(-2, -3, 0), string(2)])});
  write(folder, '0.txt', {'0,create,Knife,shape,composite', '0,move,Knife,-2.0,-3.0,0.4,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Knife', '1,move,Knife,-2.0,-3.0,2.0,0.0,0.0,0.0', ...
                          '2,move,Knife,-1.0,-2.0,1.0,0.0,0.0,0.0', '3,move,Knife,-0.7,-2.0,1.0,0.0,0.0,0.0'});
  write(folder, '2.txt', {'4,use,LeftHand,Knife,cut,String between link 1 and 2', ...
                          '4,move,Knife,-0.4,-2.0,1.0,0.0,0.0,0.0', '5,move,Knife,-2.0,-3.0,0.4,0.0,0.0,0.0'});
  write(folder, '3.txt', {'6,release,LeftHand'});
  movefile(fullfile(folder, 'rgb', '1.png'), fullfile(folder, 'rgb', '6.png'));
  demo = readDemonstration(folder);
  [steps, containers, appearances] = inferTask(demo, []);
  check(isempty(steps), 'a tool that was put back is no step');
  use = inferDevices(demo, steps, appearances);
  check(numel(use) == 1 && max(abs(use.pose - [-0.4, -2, 1, 0])) < 1e-9, 'but it was used there');
  check(max(abs(use.begin - [-1, -2, 1])) < 1e-9, 'on a straight way');
  [~, goal] = explain(demo, appearances, containers);
  check(any(strcmp(goal, 'cut String Knife')), 'to cut is the goal');
  check(isempty(use.at), 'no link says where');
  checkSides(folder);

  known = block(red, [1.8, 0.5, 0.8], 1, -3, 0, 0.5);
  for yaw = 0.5 + [0, pi]
    [picture, heights] = pictureOf(knife(1, -3, yaw));
    [k, tool] = findTool(use, known, surfaceOf(picture, heights, eye), eye);
    check(k == 1 && abs(sin((tool.yaw - yaw) / 2)) < 1e-9, 'a tool is turned as its surroundings look');
  end
  checkCarrying(eye);
end

function checkSides(folder)
% A use between links is turned about their middle.
  file = fopen(fullfile(folder, '0.txt'), 'a');
  for link = [1, 2, 3; -2.2, -1.8, 5]
    fprintf(file, '0,create,String-link%d,shape,chain-link\n0,move,String-link%d,0.6,%g,1.0,0.0,0.0,0.0\n', link(1), link);
  end
  fclose(file);
  demo = readDemonstration(folder);
  [steps, ~, appearances] = inferTask(demo, []);
  use = inferDevices(demo, steps, appearances);
  check(max(abs(use.at - [0.6, -2])) < 1e-9, 'between two links');
  alignment = struct('angle', 0, 'place', [5, 0]);
  [begin, last, yaw] = seenFrom(use, 0, alignment);
  check(max(abs([begin, last, yaw] - [-6, -2, 1, -5.4, -2, 1, 0])) < 1e-9, 'as demonstrated');
  [begin, last, yaw] = seenFrom(use, pi / 2, alignment);
  check(max(abs([begin, last, yaw] - [-4.4, -3.6, 1, -4.4, -3, 1, pi / 2])) < 1e-9, 'from another side');
end

function checkCarrying(eye)
% What sticks out of a carried tool avoids what the eye sees, and so do hand and arm.
  [picture, heights] = pictureOf([knife(-2, -3, 0), block([0.5, 0.3, 0.2], [0.5, 0.5, 3], 3, -3, 0, 0)]);
  points = surfaceOf(picture, heights, eye).points;
  is_tool = belongsTo(block([1, 0, 0], [1.8, 0.5, 0.8], -2, -3, 0, 0), points);
  check(abs(max(points(is_tool, 1)) + 0.3) < 0.05, 'the blue tip is a part of the tool');
  check(all(points(~is_tool, 1) > 2), 'the post is not');
  around = surroundingsOf(points(~is_tool, :));
  eval('function pose = smileForward(~, ~, q), pose = repmat(diag([1, -1, -1, 1]), 1, 1, rows(q)); pose(1:3, 4, :) = q''; end');
  eval('function points = armPoints(~, q), points = permute(q, [3, 2, 1]) + [0, 0, 0; 0, -1, 3]; end');
  % A path along straight lines through joint waypoints, which contains no other points: a second for each.
  eval('function q = smileSample(path, times), q = interp1(0:path.duration, path.positions, times); end');
  remove = onCleanup(@() clear('-f', 'smileForward', 'armPoints', 'smileSample'));
  arm = struct('robot', [], 'name', '', 'reach', 0.75, 'palm', 0.75);
  load = loadOf(wholeOf(points(is_tool, :), 0.4), smileForward([], '', [-2, -3, 0.6]));
  for k = [0.5, 1.5, 1.5, 2.5; 2, 2, 4, 3.5; 1, 0, 1, 0; 1, 1, 1, 0]
    path = straightPath([1; 1] * [k(1), -3, k(2)]);
    check(avoids(around, arm, path, load) == k(3), 'the tip passes over the post');
    check(avoids(around, arm, path) == k(4), 'the empty hand also beside it');
  end
  check(~avoids(around, arm, straightPath([0.5, -3, 2; 5.5, -3, 2])), 'a post between the ends of a path is in the way');
  checkWayOver(eye, arm);
  clear remove;
  checkMoved();
end

function checkMoved()
% A tool is where its hold says, whatever the hold.
  tool = block([1, 0, 0], [2, 0.5, 0.4], -2, -3, 0, 0.3);
  whole = [-1, -3, 0.1; -2.5, -2, 0.4; -2, -3.5, 0];
  arm = struct('opening', 0, 'reach', 0.75, 'palm', 0.75);
  for hold = [0.3, 1.2; 0, 0.5]
    load = loadOf(whole, heldToolPose(arm, tool, hold(1), hold(2), tool.position, 0));
    there = loadAt(load, heldToolPose(arm, tool, hold(1), hold(2), [3, -1, 2], 0.7));
    check(max(max(abs(movedTo(whole, tool, [3, -1, 2], 0.7) - there))) < 1e-9, 'a tool is moved with its hand');
  end
end

function checkWayOver(eye, arm)
% The way leads over what is between a tool and its work, and back over it. Three joint angles are the place of the tool.
  [picture, heights] = pictureOf(block([0.5, 0.3, 0.2], [0.5, 0.5, 3], 0, -3, 0, 0));
  around = surroundingsOf(surfaceOf(picture, heights, eye).points);
  eval('function q = smileInverse(~, ~, poses, varargin), q = columnsOf(poses, 4); end');
  eval('function path = smileMoveJoints(~, ~, waypoints, varargin), path = straightPathOf(waypoints); end');
  eval('function path = smileMoveLine(~, ~, q, goal, varargin), path = straightPathOf([q; goal(1:3, 4).'']); end');
  eval('function path = straightPathOf(q), path = struct(''positions'', q, ''duration'', rows(q) - 1); end');
  eval('function moment = smileFirstInvalid(varargin), moment = []; end');
  remove = onCleanup(@() clear('-f', 'smileInverse', 'smileMoveJoints', 'smileMoveLine', 'straightPathOf', 'smileFirstInvalid'));
  parked = [-5, -5, 5];
  arm = setfield(setfield(setfield(setfield(arm, 'hasTorso', false), 'parked', parked), 'starts', parked), 'allParked', []);
  arm = setfield(setfield(arm, 'lower', [-10, -10, -10]), 'upper', [10, 10, 10]);
  poseAt = @(q) smileForward([], '', q);
  over = poseAt([-3, -3, 2]);
  high = max(around.ofArm.heights(:)) + arm.reach + 0.1;
  ways = struct('is_line', {true, false, false}, 'height', {0, 0, high});
  isClear = @(path) avoids(around, arm, path);
  hold = struct('arm', arm, 'poses', {{over, poseAt([-3, -3, 1]), over}}, 'above', [-3, -3, 2]);
  taken = planToTake(hold, parked, []);
  plan = @(ways) planThereAndBack(arm, taken, {poseAt([3, -3, 2])}, {over, over}, ways, [], isClear, @(paths) isClear(paths{5}));
  check(isempty(plan(ways(1:2))), 'a post between a tool and its work is in the way');
  path = plan(ways);
  check(max(max(abs(path{4}.positions - flipud(path{5}.positions)))) < 1e-9, 'the way back is the way there');
  check(isequal(path{4}.positions([1, end], :), [-3, -3, 2; 3, -3, 2]), 'it leads from the tool to its work');
  check(abs(max(path{4}.positions(:, 3)) - high) < 1e-9, 'it leads over the post');
end

function path = straightPath(waypoints)
  path = struct('positions', waypoints, 'duration', rows(waypoints) - 1);
end

function blocks = knife(x, y, yaw)
  tip = [x, y] + rotated([1.3, 0], yaw);
  blocks = [block([1, 0, 0], [1.8, 0.5, 0.8], x, y, 0, yaw), block([0, 0, 1], [0.8, 0.3, 0.4], tip(1), tip(2), 0, yaw)];
end
