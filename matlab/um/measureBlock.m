function block = measureBlock(top, picture, eye, table)
% The block on the table that has this top, of whatever size; a 1x0 struct array if it is not seen whole.
%   top  as from topsIn
  block = noBlocks();
  height = heightOf(top, picture, eye, table);
  if isempty(height), return; end
  [x, y, area] = ontoPlane(top.row, top.column, eye, height);
  face = describeFace(x, y, area);
  if face.misfit > constants().see.misfit, return; end
  block(1) = struct('color', top.color, 'size', [face.sides, height], ...
                    'position', [face.center, height / 2], 'yaw', face.yaw);
end
