function rectangles = gripRoom(blocks)
% What blocks cover, seen from above, and with them open fingers at their longer sides: see footprint.
  rectangles = footprint(blocks, 0.05);
  rectangles(:, 4) = rectangles(:, 4) + 0.8;
end
