function height = estimateHeight(top, picture, eye, table)
% Estimates the height of a block on the table [units]: below the edge of its top one of its sides is
% visible, down to where the table begins. [] if something else is there.
%   top    as from segmentTopFaces
%   table  color of the table, 1x3
  height = [];
  c = constants().perception;
  [u, v] = edgeTowardNadir(top, eye);
  for trial = c.height_trials(1):c.height_trials(2):c.height_trials(3)
    [x, y] = ontoPlane(v + 0.5, u + 0.5, eye, trial);
    color = colorAt(picture, eye, [x, y, 0]);
    if isempty(color) || ~isDarkerShade(color, top.color), break; end
  end
  % The resolution of the picture allows no finer steps; flatter objects are not blocks.
  rounded = round(c.heights_per_unit * trial) / c.heights_per_unit;
  if ~isempty(color) && max(abs(color - table)) < c.table_tolerance && rounded > 0, height = rounded; end
end
