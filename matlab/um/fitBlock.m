function blocks = fitBlock(row, column, eye, kinds, container)
% The block, one of some kinds, whose top these pixels are; a 1x0 struct array if they are none.
%
% On a lower plane the same pixels would be a larger top, on a higher one a smaller. Blocks lie on
% blocks, so there are only few planes to try: the one on which the top is as large as it should be is
% the one it lies on. In a container, if there is one, all planes are higher by its floor.
  most_floors = 6;
  best = 0.08;  % by how much, in proportion, a side may be wrong
  blocks = noBlocks();
  for k = 1:numel(kinds)
    for top = kinds(k).size(3) + (0:most_floors - 1)
      face = faceAt(top);
      if isInside(container, face.center)
        top = top + container.floor;
        face = faceAt(top);
      end
      wrong = max([abs(face.sides ./ kinds(k).size(1:2) - 1), face.misfit]);
      if wrong < best
        best = wrong;
        blocks = struct('color', kinds(k).color, 'size', kinds(k).size, ...
                        'position', [face.center, top - kinds(k).size(3) / 2], 'yaw', face.yaw);
      end
    end
  end

  function face = faceAt(height)
    [x, y, area] = ontoPlane(row, column, eye, height);
    face = describeFace(x, y, area);
  end
end
