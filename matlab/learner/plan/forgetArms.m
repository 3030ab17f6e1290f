function state = forgetArms(state, arms, sensor)
% Forgets unknown objects that are parts of the robot's own arms, where these wait in view.
  c = constants().motion_planning;
  for arm = arms
    links = pointsBetween(armPoints(arm, sensor.arms(arm.index).joints(:)'), c.points_per_link);
    is_kept = true(1, numel(state.known));
    for k = 1:numel(state.known)
      block = state.known(k);
      is_unknown = any(arrayfun(@(kind) isequal(kind.size, block.size), state.unknownObjects));
      is_kept(k) = ~is_unknown || min(vecnorm(links - block.position, 2, 2)) > c.arm_radius + max(block.size) / 2;
    end
    state.known = state.known(is_kept);
  end
end
