function tops = blockTops(blocks)
% Returns the heights of the tops of blocks, Nx1 [units].
  tops = zeros(0, 1);
  if isempty(blocks), return; end
  places = vertcat(blocks.position);
  sizes = vertcat(blocks.size);
  tops = places(:, 3) + sizes(:, 3) / 2;
end
