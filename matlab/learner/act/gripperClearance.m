function rectangles = gripperClearance(blocks)
% Returns the areas that blocks cover together with open fingers at their longer sides: see footprint.
  c = constants().clearance;
  rectangles = footprint(blocks, c.grip_margin);
  rectangles(:, 4) = rectangles(:, 4) + c.open_fingers;
end
