function yes = isTableVisible(picture, eye, block, table)
% Returns true if the pixel at the middle of a block's top shows the table, of a color, 1x3.
  color = colorAt(picture, eye, block.position + [0, 0, block.size(3) / 2]);
  yes = ~isempty(color) && max(abs(color - table)) < constants().perception.table_tolerance;
end
