function yes = isPlacedBy(one, other)
% Returns true if another block tells where one is: it stands on that, or is around it.
  yes = standsOn(one, other) || isAround(one, other);
end
