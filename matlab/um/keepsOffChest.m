function yes = keepsOffChest(robot, arm, q)
% Whether angles of an arm, Nx7, keep its upper arm off the chest, which it would touch with S0 turned
% farthest to the other side.
  margin = constants().carry.chest_margin_rad;
  if arm == 1
    yes = all(q(:, 1) > robot.minJointAngles(arm, 1) + margin);
  else
    yes = all(q(:, 1) < robot.maxJointAngles(arm, 1) - margin);
  end
end
