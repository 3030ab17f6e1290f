function yes = sameColor(wanted, color)
% Whether a color is the wanted one; [] wants any.
  yes = isempty(wanted) || max(abs(wanted - color)) < constants().blocks.same_color;
end
