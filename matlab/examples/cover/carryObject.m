function actions = carryObject(robot, aside, from, fromHeight, to, toHeight, over, lowerLift)
% Returns the actions that carry an object to another place and set it down parallel to it. Heights are those of the
% tips of the fingers. The fingers are at the longer sides of the object, which may be grasped, and stand, in two ways.
% It is lifted to `over`, or to `lowerLift`, if there is one, where no arm can lift it so high.
  lifts = over;
  if nargin > 7, lifts = [over, lowerLift]; end
  tip = tipLength(robot, 1);
  at = @(place, height, side) poseAt(pointAt(place, 0, 0, height + tip), side * place.y);
  for lift = lifts
    for across = {'line', 'joints'}  % a straight way keeps it level
      for sides = [1 1 -1 -1; 1 -1 1 -1]
        overFrom = at(from, lift, sides(1));
        take = at(from, fromHeight, sides(1));
        overTo = at(to, over, sides(2));
        put = at(to, toHeight + 0.02, sides(2));
        [arm, motions] = planPath(robot, aside, {'joints', overFrom; 'line', take; 'line', overFrom; ...
                                                 across{1}, overTo; 'line', put; 'line', overTo});
        if isempty(arm), continue, end
        printf('carrying with the %s arm\n', robot.arms{arm});
        wide = 0.9;  % opening around an object of 0.4
        actions = [grip(arm, -1, wide), follow(arm, motions(1:2)), grip(arm, -1, -Inf), follow(arm, motions(3:5)), ...
                   grip(arm, 1, wide), follow(arm, motions(6)), goAside(robot, arm, motions, aside)];
        return
      end
    end
  end
  error('no arm can carry it');
end
