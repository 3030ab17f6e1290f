function height = heightOf(top, picture, eye, table)
% How high a block is [units]: below the near edge of its top one of its sides is seen, down to where the
% table begins. [] if something else is there.
%   top  as from topsIn
  column = round(mean(top.column));
  row = max(top.row(top.column == column));
  height = [];
  if isempty(row), return; end  % a shape with a gap is none of a block
  for trial = 0.1:0.02:6
    [x, y] = ontoPlane(row + 0.5, column, eye, trial);
    color = colorAt(picture, eye, [x, y, 0]);
    if isempty(color), return; end
    if ~isShade(color, top.color), break; end
    height = trial;
  end
  % Pixels cannot tell it finer than that.
  height = round(4 * height) / 4;
  if max(abs(color - table)) > 0.03, height = []; end
end
