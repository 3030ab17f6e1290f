function motion = armMotion(robot, arm, q, goal)
% Plans a motion of the joints from angles to angles.
  motion = smileMoveJoints(robot, robot.arms{arm}, [q; goal], 'speed', 0.7);
end
