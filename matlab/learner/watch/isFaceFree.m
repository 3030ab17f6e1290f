function yes = isFaceFree(face, top, solid, eye)
% Returns true if almost no pixel of a face at a height shows what it would hide.
%   solid  mask of that, HxW logical, as from solid
  block = newBlock([], [face.sides, 0], [face.center, top], face.yaw);
  corners = cornersOf(block);
  pixels = filled(toPixel(corners(1:4, :), eye), size(solid));
  yes = ~isempty(pixels) && mean(solid(pixels)) < constants().watching.max_solid;
end
