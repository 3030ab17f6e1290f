function yes = showsTable(picture, eye, block, table)
% Whether the table, of a color, is seen where the middle of a block's top would be.
  color = colorAt(picture, eye, block.position + [0, 0, block.size(3) / 2]);
  yes = ~isempty(color) && max(abs(color - table)) < constants().see.table_tolerance;
end
