function kinds = learnKinds(tops, picture, eye, table)
% The different blocks among those that lie on the table, by themselves: a struct array with color and
% size.
  kinds = struct('color', {}, 'size', {});
  for top = tops
    for block = measureBlock(top, picture, eye, table)
      if ~any(arrayfun(@(kind) isLike(block, kind), kinds))
        kinds(end + 1) = struct('color', block.color, 'size', block.size);
      end
    end
  end
end
