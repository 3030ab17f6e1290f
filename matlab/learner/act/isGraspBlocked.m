function yes = isGraspBlocked(block, steps)
% Returns true if a block lies where steps will be built, or so close that no fingers fit in afterwards.
  covered = footprint(block, constants().clearance.site_margin);
  yes = any(overlap(covered, gripperClearance(steps))) || isempty(graspYaws(block, steps));
end
