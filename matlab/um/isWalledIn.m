function yes = isWalledIn(block, steps)
% Whether a block lies on the building's site, or so near that no fingers fit in once the building stands.
  covered = footprint(block, constants().room.site_margin);
  yes = any(overlap(covered, gripRoom(steps))) || isempty(fingerTurns(block, steps));
end
