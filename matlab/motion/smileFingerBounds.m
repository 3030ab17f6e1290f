function bounds = smileFingerBounds(robot, arm, opening)
%SMILEFINGERBOUNDS  Box around what moves when a gripper opens, such as its two fingers.
%
%   bounds = smileFingerBounds(robot, arm, opening)
%
%   robot    from smileRobot
%   arm      its name
%   opening  free width between the sides [units]
%   bounds   the least and the greatest x y z in the frame of the tool, 2x3 [units]
  bounds = smilemotion('smileFingerBounds', robot, arm, opening);
end
