function middle = smileGripperMiddle(robot, arm, opening)
%SMILEGRIPPERMIDDLE  Place of the middle between both sides of a gripper.
%
%   middle = smileGripperMiddle(robot, arm, opening)
%
%   robot    from smileRobot
%   arm      its name
%   opening  free width between the sides [units]
%   middle   along y of the tool [units]: 0 for fingers that slide apart, but not where one jaw is
%            fixed
  middle = smilemotion('smileGripperMiddle', robot, arm, opening);
end
