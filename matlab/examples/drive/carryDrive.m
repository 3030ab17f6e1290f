function actions = carryDrive(from, fromHeight, lifts, to, toHeight, robot, aside)
% Returns the actions that carry the drive at a place to another one and set it down parallel to it. Heights are those
% of the bottom of the drive; it is lifted to the first of `lifts` at which an arm can do so.
  grasp = 1.3;  % height of the tool above it
  carry = 2.2;  % its height over other drives
  % A straight way does not dip; the left finger goes left or right of the drive.
  for lift = lifts
    for across = {'line', 'joints'}
      for side = [1, -1]
        overFrom = poseAt(pointAt(from, 0, 0, lift + grasp), side * from.x);
        take = poseAt(pointAt(from, 0, 0, fromHeight + grasp), side * from.x);
        overTo = poseAt(pointAt(to, 0, 0, carry + grasp), side * to.x);
        put = poseAt(pointAt(to, 0, 0, toHeight + 0.02 + grasp), side * to.x);
        [arm, motions] = planPath(robot, aside, {'joints', overFrom; 'line', take; 'line', overFrom; ...
                                                 across{1}, overTo; 'line', put; 'line', overTo});
        if isempty(arm), continue, end
        printf('carrying a drive with the %s arm\n', robot.arms{arm});
        actions = [follow(arm, motions(1:2)), grip(arm, -1, -Inf), follow(arm, motions(3:5)), ...
                   grip(arm, 1, 1.3), follow(arm, motions(6)), goAside(robot, arm, motions, aside)];
        return
      end
    end
  end
  error('no arm can carry the drive');
end
