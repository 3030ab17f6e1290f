function kinds = learnKinds(tops, picture, eye, table)
% The different blocks among those that lie on the table, by themselves: a struct array with color and
% size.
  kinds = struct('color', {}, 'size', {});
  for top = tops
    height = heightOf(top, picture, eye, table);
    if isempty(height), continue; end
    [x, y, area] = ontoPlane(top.row, top.column, eye, height);
    face = describeFace(x, y, area);
    if face.misfit > 0.05, continue; end
    kind = struct('color', top.color, 'size', [face.sides, height]);
    same = arrayfun(@(other) sameColor(other.color, kind.color) && sameSize(other.size, kind.size), kinds);
    if ~any(same), kinds(end + 1) = kind; end
  end
end

function height = heightOf(top, picture, eye, table)
% How high a block is [units]: below the near edge of its top one of its sides is seen, down to where the
% table begins. [] if something else is there.
  column = round(mean(top.column));
  row = max(top.row(top.column == column));
  height = [];
  if isempty(row), return; end  % a shape with a gap is none of a block
  for trial = 0.1:0.02:6
    [x, y] = ontoPlane(row + 0.5, column, eye, trial);
    foot = round(toPixel([x, y, 0], eye) + [0.5, 0.5]);
    if any(foot < 1 | foot > [size(picture, 2), size(picture, 1)]), return; end
    color = reshape(picture(foot(2), foot(1), :), 1, 3);
    if ~isShade(color, top.color), break; end
    height = trial;
  end
  % Pixels cannot tell it finer than that.
  height = round(4 * height) / 4;
  if max(abs(color - table)) > 0.03, height = []; end
end
