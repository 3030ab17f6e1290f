function kinds = learnBlockKinds(tops, picture, eye, table)
% Returns the kinds of the blocks that lie by themselves on the table: a struct array with color and size.
%   tops  as from segmentTopFaces
  kinds = struct('color', {}, 'size', {});
  for top = tops
    for block = measureBlock(top, picture, eye, table)
      if ~any(arrayfun(@(kind) isSameKind(block, kind), kinds))
        kinds(end + 1) = struct('color', block.color, 'size', block.size);
      end
    end
  end
end
