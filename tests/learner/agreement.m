% Evaluates the learner's functions in Octave for the inputs of agreement_test.py; prints a number on each
% line. octave-cli agreement.m, with matlab/learner on the path.
1;

function show(numbers)
  printf('%.17g\n', double(numbers));
end

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
end
[x, y] = meshgrid(-20:20, -20:20);
inside = hypot(x, y) < 20;
face = fitFace(x(inside), y(inside), ones(nnz(inside), 1));
show([face.center, face.sides, face.misfit, face.isRound]);
