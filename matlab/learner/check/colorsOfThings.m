function colors = colorsOfThings(things)
% Returns the colors of things, their knobs and the parts of those of several colors, Nx3, each once.
  knobs = [things.knob];
  all_colors = vertcat(zeros(0, 3), things.color);
  if ~isempty(knobs), all_colors = [all_colors; vertcat(knobs.color)]; end
  for thing = things(~cellfun(@isempty, {things.parts})), all_colors = [all_colors; vertcat(thing.parts.color)]; end
  [~, first] = unique(all_colors, 'rows', 'first');
  colors = all_colors(sort(first), :);
end
