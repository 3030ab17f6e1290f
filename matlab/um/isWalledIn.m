function yes = isWalledIn(block, steps)
% Whether a block lies on the building's site, or so near that no fingers fit in once the building stands.
  yes = any(overlap(footprint(block, 0.1), gripRoom(steps))) || isempty(fingerTurns(block, steps));
end
