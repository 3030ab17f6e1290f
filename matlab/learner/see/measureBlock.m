function block = measureBlock(top, picture, eye, table, heights)
% Measures the block that has a top face, of any size; a 1x0 struct array if it is not entirely visible.
% Without heights it must stand on the table.
%   top      as from segmentTopFaces
%   table    color of the table, 1x3
%   heights  as from heightMap; [] or omitted if the eye measures no depth
  block = noBlocks();
  if nargin < 5 || isempty(heights)
    height = estimateHeight(top, picture, eye, table);
    ground = 0;
  else
    height = median(heights(sub2ind(size(heights), top.row, top.column)));
    ground = groundBelow(top, picture, eye, heights);
  end
  if isempty(height) || isempty(ground) || height - ground < constants().perception.on_table, return; end
  [x, y, area] = ontoPlane(top.row, top.column, eye, height);
  face = fitFace(x, y, area);
  if face.misfit > constants().perception.misfit, return; end
  form = 'block';
  if face.isRound, form = 'disc'; end
  block(1) = newBlock(top.color, [face.sides, height - ground], [face.center, (height + ground) / 2], face.yaw, form);
end
