function kinds = learnBlockKinds(tops, picture, eye, table)
% Returns the kinds of the blocks that lie by themselves on the table: as from blockKinds.
%   tops  as from segmentTopFaces
  kinds = blockKinds(noBlocks(), []);
  for top = tops
    for block = measureBlock(top, picture, eye, table)
      if ~any(arrayfun(@(kind) isSameKind(block, kind), kinds))
        kinds(end + 1) = struct('color', block.color, 'size', block.size, 'form', block.form, 'parts', []);
      end
    end
  end
end
