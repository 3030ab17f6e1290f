function yes = showsTable(picture, eye, block, table)
% Whether the table, of a color, is seen where the middle of a block's top would be.
  spot = round(toPixel(block.position + [0, 0, block.size(3) / 2], eye) + 0.5);
  inside = all(spot >= 1 & spot <= [size(picture, 2), size(picture, 1)]);
  yes = inside && max(abs(reshape(picture(spot(2), spot(1), :), 1, 3) - table)) < 0.03;
end
