function some = reaching(arms, place)
% Returns those arms that reach a block's place.
  some = arms(arrayfun(@(arm) isReachable(arm, place), arms));
end
