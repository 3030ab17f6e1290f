function state = forgetArm(state, arm, sensor)
% Forgets what was taken for an object and is a part of an arm that waits in view.
  c = constants().motion_planning;
  links = pointsBetween(armPoints(arm, sensor.arms(arm.index).joints(:)'), c.points_per_link);
  is_kept = true(1, numel(state.known));
  for k = 1:numel(state.known)
    block = state.known(k);
    if any(arrayfun(@(step) isSameKind(block, step), state.steps)), continue; end
    away = links - block.position;
    away = abs([rotated(away(:, 1:2), -block.yaw), away(:, 3)]) - block.size / 2;
    is_kept(k) = min(vecnorm(max(away, 0), 2, 2)) >= c.arm_radius;
  end
  state.known = state.known(is_kept);
end
