function height = turnHeight(block, others)
% Returns the height of the tool at which a block turns above all others [units].
  height = max([0; blockTops(others)]) + norm(block.size([1, 3])) + constants().motion_planning.clearance;
end
