function state = forgetArm(state, arm, sensor)
% Forgets what was taken for an object and is a part of an arm that waits in view.
  links = linksOf(arm, sensor.arms(arm.index).joints(:)');
  is_kept = true(1, numel(state.known));
  for k = 1:numel(state.known)
    block = state.known(k);
    is_wanted = any(arrayfun(@(step) isSameKind(block, step), state.steps));
    is_kept(k) = is_wanted || all(isPointClear(links, block, 0));
  end
  state.known = state.known(is_kept);
end
