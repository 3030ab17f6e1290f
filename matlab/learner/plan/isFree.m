function yes = isFree(covered, taken)
% Returns which of N areas, Nx5 as from footprint, have room between some blocks, with the fingers of both: Nx1 logical.
  c = constants();
  with_fingers = covered + [0, 0, 0, c.task_planning.place_fingers, 0];
  yes = ~any(overlap(footprint(taken, c.clearance.site_margin), with_fingers), 2);
  % Square blocks can also be held across the other sides.
  is_long = ~arrayfun(@hasEqualSides, taken);
  yes = yes & ~any(overlap(gripperClearance(taken(is_long)), covered), 2);
end
