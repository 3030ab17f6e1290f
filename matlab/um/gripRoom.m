function rectangles = gripRoom(blocks)
% What blocks cover, seen from above, and with them open fingers at their longer sides: see footprint.
  c = constants().room;
  rectangles = footprint(blocks, c.grip_margin);
  rectangles(:, 4) = rectangles(:, 4) + c.open_fingers;
end
