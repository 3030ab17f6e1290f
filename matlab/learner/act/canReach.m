function yes = canReach(arms, place)
% Returns true if one of the arms reaches a block's place.
  yes = any(arrayfun(@(arm) isReachable(arm, place), arms));
end
