function blocks = fitBlocks(row, column, eye, kinds, containers, isPossible, bottoms, top, max_side_error)
% Fits blocks to the pixels of a top face: one block of some kind, or equal blocks that touch in a row or
% a grid. Returns a 1xN struct array, 1x0 if nothing fits.
%   row, column  pixels, Nx1
%   kinds        as from blockKinds
%   containers   in which they may lie, or []
%   isPossible   predicate: returns true if there can be a block at such a place
%   bottoms      for each kind, the heights where the bottom is expected [units], cell
%   top          measured height of the face [units]; [] or omitted if there is none
%   max_side_error  greatest relative error of the sides; optional
%
% On a lower plane the same pixels would be a larger top, on a higher one a smaller. Without a measured
% height, the plane is the one of the expected ones at which the size of the top is right. Inside a
% container, all planes are higher by its floor. With a measured height, blocks whose bottom would be where
% it is expected are preferred: the size of the top alone does not distinguish a high block from a low one
% on a support.
  if nargin < 8, top = []; end
  c = constants().perception;
  best = c.max_side_error;
  if nargin == 9, best = max_side_error; end
  blocks = noBlocks();
  for pass = [1, 1, c.max_abreast, c.max_abreast; true, false, true, false]
    max_count = pass(1);  % blocks side by side
    for k = 1:numel(kinds)
      for plane = candidateTops(kinds(k).size, bottoms{k}, top, pass(2))
        face = faceAt(plane);
        around = [];
        if isempty(top), around = containerAt(containers, face.center); end
        if ~isempty(around)
          plane = plane + around.floor;
          face = faceAt(plane);
        end
        if face.isRound ~= isRound(kinds(k)), continue; end
        most = max_count;
        if face.isRound, most = 1; end
        count = max(1, min(most, round(face.sides ./ kinds(k).size(1:2))));
        max_error = max([abs(face.sides ./ (count .* kinds(k).size(1:2)) - 1), face.misfit]);
        if max_error >= best, continue; end
        found = blockGrid(face, count, plane, kinds(k));
        if (~isempty(top) && pass(2)) || all(arrayfun(isPossible, found))
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

function tops = candidateTops(size, bottoms, top, is_expected)
% Returns the heights at which the top of a block may be, 1xN [units]: its measured height, or, if there is
% none, those at which its bottom is expected.
%   is_expected  whether to return the heights with an expected bottom, or the others
  tops = zeros(1, 0);
  near = constants().perception.on_table;
  if isempty(top)
    if is_expected, tops = size(3) + bottoms; end
  elseif (min(abs(top - size(3) - bottoms)) < near) == is_expected && top - size(3) > -near
    tops = top;
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
      blocks(end + 1) = newBlock(kind.color, kind.size, [at, top - kind.size(3) / 2], face.yaw, kind.form);
    end
  end
end
