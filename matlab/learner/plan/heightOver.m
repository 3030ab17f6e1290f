function height = heightOver(arm, place, height)
% Returns the height of the tool at which its tilted fingers pass over a block at a place; at least some height [units].
  height = max(height, blockTops(place) + lowestTiltedTool(arm) + constants().motion_planning.clearance);
end
