function surroundings = surroundingsOf(points)
% Returns what visible points, Nx3 [units], are for a hand and its load, which must avoid them: two skylines (see skylineOf),
% widened, ofLoad and ofArm.
  c = constants();
  skyline = skylineOf(points + [0, 0, c.skyline.margin]);
  surroundings.ofLoad = widened(skyline, c.skyline.margin);
  surroundings.ofArm = widened(skyline, c.motion_planning.arm_radius);
end
