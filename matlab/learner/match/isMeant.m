function yes = isMeant(meant, block)
% Returns by which of N steps a block is meant, see meantBlocks: Nx1 logical.
  yes = vecnorm(meant - block.position, 2, 2) < constants().beliefs.same_block_distance;
end
