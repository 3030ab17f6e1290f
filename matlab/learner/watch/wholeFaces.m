function faces = wholeFaces(face, sides)
% Returns a face (see fitFace) with the sides of a size, the longer one first; a 1x0 struct array if it has others.
  face = longerSideFirst(face);
  away = max([abs(face.sides ./ sides(1:2) - 1), face.misfit]);
  faces = face([]);
  if away < constants().watching.max_side_error && ~face.isRound, faces = face; end
end
