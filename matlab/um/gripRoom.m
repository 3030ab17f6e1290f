function rectangle = gripRoom(place)
% What a block covers at a place, and open fingers at its longer sides, seen from above: see footprint.
  rectangle = footprint(place, 0.05);
  rectangle.sides(2) = rectangle.sides(2) + 1.1;
end
