function yes = hasPartsOf(one, other, is_colored)
% Returns true if two things of several colors have the same layout of parts (see measureParts), also in colors if
% these count.
  yes = ~isempty(one.parts) && numel(one.parts) == numel(other.parts);
  for a = one.parts
    yes = yes && any(arrayfun(@(b) isSamePart(a, b, is_colored), other.parts));
  end
end

function yes = isSamePart(a, b, is_colored)
  yes = norm(a.position - b.position) < constants().parts.same_place && sameSize(a.size(1:2), b.size(1:2)) && ...
        (~is_colored || sameColor(a.color, b.color));
end
