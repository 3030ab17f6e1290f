function blocks = spaceOf(blocks)
% Returns blocks; things of several colors as large as the space that they may fill: their parts are only what is known.
  if isempty(blocks), return; end
  around = constants().parts.around;
  for k = find(~cellfun(@isempty, {blocks.parts}))
    it = blocks(k);
    parts = vertcat(it.parts.position);
    top = it.position(3) + max(parts(:, 3)) + around;
    height = top - (it.position(3) - it.size(3) / 2);
    blocks(k).size = [it.size(1:2) + 2 * around, height];
    blocks(k).position(3) = top - height / 2;
  end
end
