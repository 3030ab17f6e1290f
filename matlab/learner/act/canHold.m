function yes = canHold(arm, width)
% Returns true if the gripper of an arm opens far enough for a width [units].
  yes = arm.opening >= width + constants().arms.opening_margin;
end
