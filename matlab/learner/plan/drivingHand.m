function hand = drivingHand(arm, width, grip)
% Returns how an arm holds an upright tool of a width at a height above its center, so that its last joint turns the tool about
% its axis.
%   hand.middle          angle of that joint in the middle of its limits [rad]
%   hand.strokesPerTurn  wrists turn by less than a full turn
%   hand.clockwise       angle of a stroke, clockwise as seen from above [rad]
  c = constants().uses;
  hand = struct('arm', arm, 'width', width, 'grip', grip, 'middle', (arm.lower(end) + arm.upper(end)) / 2);
  hand.strokesPerTurn = ceil(c.turn_rad / (arm.upper(end) - arm.lower(end) - 2 * c.limit_margin_rad));
  jacobian = smileJacobian(arm.robot, arm.name, arm.ready);
  hand.clockwise = -sign(jacobian(6, end)) * c.turn_rad / hand.strokesPerTurn;
end
