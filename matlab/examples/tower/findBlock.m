function block = findBlock(image, camera, color)
% Finds the block of a color in the head camera's image; [] if it is not there.
%   block.position  of the middle of its top [units], 1x3
%   block.yaw       of its sides [rad], -pi/4 to pi/4
  block = [];
  [row, column] = find(topFace(image, hueOf(color)));
  if numel(row) < 50, return; end

  % A top is one unit square. Seen as if it lay on a lower plane it looks larger, on a higher plane
  % smaller: the plane on which its area is 1 is the one it lies on. Blocks lie on blocks, so the
  % heights are whole units.
  misfit = Inf;
  for z = 1:5
    [x, y, area] = ontoPlane(row, column, camera, z);
    if abs(log(sum(area))) < misfit
      misfit = abs(log(sum(area)));
      center = [sum(x .* area), sum(y .* area)] / sum(area);
      block = struct('position', [center, z], 'yaw', squareYaw(x - center(1), y - center(2), area));
    end
  end
  if misfit > 0.1, block = []; end  % something hides a part of it
end
