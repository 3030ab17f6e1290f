function colors = unclearColors(classes, view, kinds, palette)
% Returns the colors of which a picture shows tops that no block explains, Nx3. The arguments are as for candidates.
  colors = zeros(0, 3);
  [tops, first] = unique(arrayfun(@(it) topClass(palette, it.color), kinds), 'first');
  for k = 1:numel(tops)
    color = kinds(first(k)).color;
    areas = areasIn(classes == tops(k) & ~explained(view, color), constants().perception.min_top_pixels);
    if ~isempty(areas), colors(end + 1, :) = color; end
  end
end
