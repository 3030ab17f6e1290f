function angles = turnsOf(arm)
% Returns angles of an arm's first joint that turn it all around, with a distance from its limits: 1xN [rad].
  c = constants().arms;
  range = min(max([arm.lower(1), arm.upper(1)] * c.parked_limit, -pi), pi);
  angles = range(1):c.parked_turn_rad:range(2) + c.parked_turn_rad / 2;
end
