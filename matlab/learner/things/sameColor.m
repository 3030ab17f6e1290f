function yes = sameColor(wanted, color)
% Returns true if a color, 1x3, is the wanted one; [] accepts any.
  yes = isempty(wanted) || max(abs(wanted - color)) < constants().blocks.same_color;
end
