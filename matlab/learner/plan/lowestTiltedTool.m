function height = lowestTiltedTool(arm)
% Returns how high the tool of an arm must be for its tilted fingers to stay above the table [units].
  c = constants().motion_planning;
  height = (arm.reach + c.tilted_finger) / sqrt(2) + c.fingers_above_bottom;
end
