% Evaluates the learner's functions in Octave for the inputs of agreement_test.py; prints a number on each
% line. octave-cli agreement.m, with matlab/learner on the path.
1;
addpath(genpath(fileparts(which('agentBehavior'))));  % with the folders of its parts

function show(numbers)
  printf('%.17g\n', double(numbers));
end

% No robot is here: each place is suitable, and each plan possible.
function yes = isSuitable(varargin)
  yes = true;
end

function [actions, reason] = planToPlace(varargin)
  actions = {0};
  reason = '';
end

eye.table = [20, 12];
eye.intrinsics = [415.7, 0, 320; 0, 415.7, 240; 0, 0, 1];
c = cos(2.55);
s = sin(2.55);
eye.pose = [1, 0, 0, 0.1; 0, c, -s, -6.1; 0, s, c, 11.6; 0, 0, 0, 1];
rectangles = zeros(0, 5);
for k = 0:39
  % Points and shapes of patches of pixels.
  [column, row] = meshgrid(100 + 9 * k + (0:3 + mod(k, 5)), 120 + 7 * k + (0:9));
  [x, y, area] = ontoPlane(row(:) + 1, column(:) + floor(row(:) / 4) + 1, eye, 0.1 * k);
  show([x'; y'; area']);
  face = fitFace(x, y, area);
  show([face.center, face.yaw, face.sides, face.misfit]);
  face = fitFace(x, y, area, 0.1 * k);
  show([face.yaw, face.sides, face.misfit]);
  show(toPixel([x(1), y(1), 0.1 * k], eye));

  % Overlaps and grasps.
  rectangles(end + 1, :) = [mod(37 * k, 11) / 2, mod(23 * k, 7) / 2, 0.5 + mod(k, 4), 1, 0.3 * k];
  show(overlap(rectangles(end, :), rectangles));
  place = newBlock([], [rectangles(end, 3) + 1, 1, 1], [rectangles(end, 1:2), 0.5], 0.3 * k);
  other = place;
  other.position = [2, 1, 0.5 + mod(k, 3)];
  show(graspYaws(place, other));
  show(isGraspBlocked(place, other));
  show(yawDifference(place, 1 - 0.2 * k));
  show(isFree(rectangles, [place, other]));
end
[x, y] = meshgrid(-20:20, -20:20);
inside = hypot(x, y) < 20;
face = fitFace(x(inside), y(inside), ones(nnz(inside), 1));
show([face.center, face.sides, face.misfit, face.isRound]);

% Of which blocks, and for which place of a plank, if any plan succeeds.
color = [0, 0, 0];
eye.pose(2:3, 3) = [s; c];
eye.pose(3, 2) = -s;
known = newBlock(color, [5, 1, 1], [-4, -0.2, 0.5], 0);
for x = -6:3:6
  for y = [-4.5, -2.8, -1], known(end + 1) = newBlock(color, [1, 1, 1], [x, y, 0.5], 0); end
end
step = newStep(newBlock(color, [1, 1, 1], [0, -2, 0.5], 0), 'step');
state = initialTaskState(step, []);
state.known = known;
for goal = {[], step}
  for move = roomMoves(state, 1, newMove(1, goal{1}), 1:numel(known), [], eye, [])
    show([known(move.block).position, move.room.position, move.room.yaw]);
  end
end

% Visible points as a skyline, as parts of a tool, and as a load.
k = (0:399)';
points = [mod(37 * k, 101) / 20, mod(23 * k, 67) / 20, mod(11 * k, 29) / 10 + 0.1];
for margin = [0.1, 0.65]
  skyline = widened(skylineOf(points), margin);
  show(skyline.corner);
  show(skyline.heights);
  show(arrayfun(@(i) isSkylineBelow(skyline, points(i, :) + [0, 0, 0.5]), 1:400));
end
tool = newBlock([], [2, 0.5, 1], [1, 1.5, 0.5], 0.4);
some = points(1:3:end, :);
is_tool = belongsTo(tool, some);
show(is_tool);
show(loadOf(wholeOf(some(is_tool, :), 0.5), [1, 0, 0, 1; 0, -1, 0, 2; 0, 0, -1, 3; 0, 0, 0, 1]));

% By how much colors changed, and which are the same; 9 and 0 if they are not; and how much brighter it is.
for k = 0:59
  i = (1:3)';
  wanted = [mod(37 * i * k, 11), mod(23 * i + k, 7), mod((i + 1) * k, 5)] / 10;
  i = (1:5)';
  seen = [mod(31 * i * k, 11), mod(23 * i + k, 6), mod((i + 1) * k, 5)] / 12;
  changes = colorChanges(wanted, seen);
  show(min(changes, 9));
  columns = clearMatches(changes);
  columns(isnan(columns)) = 0;
  show(columns);
  shown = 0.05 + 0.9 * mod((1:24)' * [0.754877, 0.569840, 0.430159] + 0.1 * k, 1);
  seen = brightened(shown(1:15, :), [0.5 + 0.02 * k, 0.6 + 0.01 * k, 1]);
  show(gainsBetween(shown, shown));
  show(gainsBetween(shown, round(255 * seen) / 255));
end

% A picture of four faces, with noise and without.
[column, row] = meshgrid(0:29, 0:23);
face = 0.1 + 0.25 * floor(row / 12) + 0.4 * floor(column / 15);
for k = 1:3
  noise = 0.04 * (mod(row * (31 + k) + column * 17, 23) / 22 - 0.5);
  picture(:, :, k) = min(max(face * (k / 2) + noise, 0), 1);
end
show(noiseOf(picture));
show(withoutNoise(picture, 0.04, 4));
show(withoutNoise(picture, 0.08, 1));
