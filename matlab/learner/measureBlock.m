function block = measureBlock(top, picture, eye, table)
% Measures the block on the table that has a top face, of any size; a 1x0 struct array if it is not
% entirely visible.
%   top    as from segmentTopFaces
%   table  color of the table, 1x3
  block = noBlocks();
  height = estimateHeight(top, picture, eye, table);
  if isempty(height), return; end
  [x, y, area] = ontoPlane(top.row, top.column, eye, height);
  face = fitFace(x, y, area);
  if face.misfit > constants().perception.misfit, return; end
  block(1) = struct('color', top.color, 'size', [face.sides, height], ...
                    'position', [face.center, height / 2], 'yaw', face.yaw);
end
