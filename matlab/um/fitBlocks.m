function blocks = fitBlocks(row, column, eye, kinds, container, isPossible)
% The block, one of some kinds, whose top these pixels are; or several equal ones in a row, or in rows,
% that touch; a 1x0 struct array if they are neither.
%   container   in which they may lie, or []
%   isPossible  tells of a block, as it seems to be, whether it can be there
%
% On a lower plane the same pixels would be a larger top, on a higher one a smaller. Blocks lie on
% blocks, so there are only few planes to try: the one on which the top is as large as it should be is
% the one it lies on. In a container, if there is one, all planes are higher by its floor.
  c = constants().see;
  best = c.side_error;  % by how much, in proportion, a side may be wrong
  blocks = noBlocks();
  for most = [1, c.most_abreast]  % equal ones side by side
    for k = 1:numel(kinds)
      for top = kinds(k).size(3) + (0:c.most_floors - 1)
        face = faceAt(top);
        if isInside(container, face.center)
          top = top + container.floor;
          face = faceAt(top);
        end
        count = max(1, min(most, round(face.sides ./ kinds(k).size(1:2))));
        wrong = max([abs(face.sides ./ (count .* kinds(k).size(1:2)) - 1), face.misfit]);
        if wrong >= best, continue; end
        found = inRows(face, count, top, kinds(k));
        if all(arrayfun(isPossible, found))
          best = wrong;
          blocks = found;
        end
      end
    end
    if ~isempty(blocks), return; end
  end

  function face = faceAt(height)
    [x, y, area] = ontoPlane(row, column, eye, height);
    face = describeFace(x, y, area);
  end
end

function blocks = inRows(face, count, top, kind)
  blocks = noBlocks();
  along = [cos(face.yaw), sin(face.yaw)];
  across = [-along(2), along(1)];
  for i = (1:count(1)) - (count(1) + 1) / 2
    for j = (1:count(2)) - (count(2) + 1) / 2
      at = face.center + i * kind.size(1) * along + j * kind.size(2) * across;
      blocks(end + 1) = struct('color', kind.color, 'size', kind.size, ...
                               'position', [at, top - kind.size(3) / 2], 'yaw', face.yaw);
    end
  end
end
