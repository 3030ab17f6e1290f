function blocks = fitBlocks(row, column, eye, kinds, container, isPossible)
% Fits blocks to the pixels of a top face: one block of some kind, or equal blocks that touch in a row or
% a grid. Returns a 1xN struct array, 1x0 if nothing fits.
%   row, column  pixels, Nx1
%   kinds        struct array with color and size
%   container    in which they may lie, or []
%   isPossible   predicate: returns true if there can be a block at such a place
%
% On a lower plane the same pixels would be a larger top, on a higher one a smaller. Blocks lie on blocks,
% so only few planes are possible: the one at which the size of the top is right. Inside the container,
% all planes are higher by its floor.
  c = constants().perception;
  best = c.max_side_error;  % relative error of the sides
  blocks = noBlocks();
  for max_count = [1, c.max_abreast]  % blocks side by side
    for k = 1:numel(kinds)
      for top = kinds(k).size(3) + (0:c.max_layers - 1)
        face = faceAt(top);
        if isInside(container, face.center)
          top = top + container.floor;
          face = faceAt(top);
        end
        count = max(1, min(max_count, round(face.sides ./ kinds(k).size(1:2))));
        max_error = max([abs(face.sides ./ (count .* kinds(k).size(1:2)) - 1), face.misfit]);
        if max_error >= best, continue; end
        found = blockGrid(face, count, top, kinds(k));
        if all(arrayfun(isPossible, found))
          best = max_error;
          blocks = found;
        end
      end
    end
    if ~isempty(blocks), return; end
  end

  function face = faceAt(height)
    [x, y, area] = ontoPlane(row, column, eye, height);
    face = fitFace(x, y, area);
  end
end

function blocks = blockGrid(face, count, top, kind)
% Returns count(1) x count(2) equal blocks that fill a face at height `top` [units].
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
