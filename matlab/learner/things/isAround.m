function yes = isAround(outer, inner)
% Returns true if a block with an outline, like a ring or an L, has another one in its hole or its corner.
  gap = constants().task_model.max_support_gap;
  apart = abs(outer.position(3) - inner.position(3)) - (outer.size(3) + inner.size(3)) / 2;
  yes = ~isempty(outer.outline) && apart < -gap && overlap(footprint(outer, 0), footprint(inner, 0));
end
