function corners = cornersOf(block)
% Returns the corners of a block, first the four of its top in turn, then those below them: 8x3 [units].
  around = [1, 1; -1, 1; -1, -1; 1, -1] / 2 .* block.size(1:2);
  around = rotated(around, block.yaw) + block.position(1:2);
  half = block.size(3) / 2 * ones(4, 1);
  corners = [around, block.position(3) + half; around, block.position(3) - half];
end
