function yes = isNeeded(needs, segment)
% Returns true if what was done in a segment is needed; needs: see needsOf.
  yes = any(needs.sufficient == sum(needs.firsts <= segment));
end
