function yes = isGraspBlocked(blocks, steps)
% Returns which of some blocks lie where steps will be built, or so close that no fingers fit in afterwards: 1xN logical.
  yes = false(1, 0);
  if isempty(blocks), return; end
  covered = footprint(blocks, constants().clearance.site_margin);
  yes = any(overlap(covered, gripperClearance(steps)), 1);
  for k = find(~yes), yes(k) = isempty(graspYaws(blocks(k), steps)); end
end
