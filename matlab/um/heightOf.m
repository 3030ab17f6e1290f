function height = heightOf(top, picture, eye, table)
% How high a block is [units]: below the edge of its top one of its sides is seen, down to where the table
% begins. [] if something else is there.
%   top  as from topsIn
  height = [];
  c = constants().see;
  [u, v] = edgeBelow(top, eye);
  for trial = c.height_trials(1):c.height_trials(2):c.height_trials(3)
    [x, y] = ontoPlane(v + 0.5, u + 0.5, eye, trial);
    color = colorAt(picture, eye, [x, y, 0]);
    if isempty(color) || ~isShade(color, top.color), break; end
  end
  % Pixels cannot tell it finer than that; flatter things are no blocks.
  rounded = round(c.heights_per_unit * trial) / c.heights_per_unit;
  if ~isempty(color) && max(abs(color - table)) < c.table_tolerance && rounded > 0, height = rounded; end
end

function [u, v] = edgeBelow(top, eye)
% Where the top ends, in the picture [pixels], straight below its middle: towards where whoever looks
% straight down would look.
  nadir = toPixel(eye.pose(1:3, 4) - [0; 0; 1], eye);
  u = mean(top.column) - 0.5;
  v = mean(top.row) - 0.5;
  way = 0.5 * (nadir - [u, v]) / norm(nadir - [u, v]);
  while any(top.column == ceil(u) & top.row == ceil(v))
    u = u + way(1);
    v = v + way(2);
  end
end
