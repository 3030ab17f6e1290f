function yes = isValidAt(arm, q)
% Returns true if the arm touches neither the robot nor the table.
  still = smileMoveJoints(arm.robot, arm.name, q);
  yes = isempty(smileFirstInvalid(arm.robot, still, 'table', constants().arms.table'));
end
