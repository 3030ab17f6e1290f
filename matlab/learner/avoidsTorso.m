function yes = avoidsTorso(robot, arm, q)
% Returns true if joint angles of an arm, Nx7 [rad], keep its upper arm away from the torso, which it
% would touch with S0 at the limit toward the other side.
  margin = constants().motion_planning.torso_margin_rad;
  if arm == 1
    yes = all(q(:, 1) > robot.minJointAngles(arm, 1) + margin);
  else
    yes = all(q(:, 1) < robot.maxJointAngles(arm, 1) - margin);
  end
end
