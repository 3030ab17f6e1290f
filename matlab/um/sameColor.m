function yes = sameColor(wanted, color)
% Whether a color is the wanted one; [] wants any.
  yes = isempty(wanted) || max(abs(wanted - color)) < 0.05;
end
