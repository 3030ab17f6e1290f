function face = longerSideFirst(face)
% Returns a face (see fitFace) whose first side is the longer one.
  if face.sides(1) >= face.sides(2), return; end
  face.yaw = face.yaw + pi / 2;
  face.sides = face.sides([2, 1]);
end
