function yes = isCovered(object, others)
% Returns true if one of the others lies on an object.
  top = object.position(3) + object.size(3) / 2;
  bottoms = arrayfun(@(other) other.position(3) - other.size(3) / 2, others);
  on_top = others(abs(bottoms - top) < 0.15);
  yes = any(overlap(footprint(object, 0), footprint(on_top, 0)));
end
