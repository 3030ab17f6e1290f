function height = transferHeight(arm, blocks, bottom, extent)
% Returns the height of an arm's tool between two places [units]: the held block passes over all others, and
% so do the empty fingers, also over the placed block.
%   bottom  height of the goal's bottom [units]
%   extent  height of the held block [units]
  c = constants().motion_planning;
  highest = max(arrayfun(@(block) block.position(3) + block.size(3) / 2, blocks));
  height = max(max(highest, bottom) + extent, max(highest, bottom + extent) + arm.reach) + c.clearance;
end
