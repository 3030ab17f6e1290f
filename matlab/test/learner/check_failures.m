function check_failures()
  there = block([1, 0, 0], [1, 1, 1], 3, -2, 0, 0);
  goal = block([1, 0, 0], [1, 1, 1], 0, -2, 0, 0);
  state = initialTaskState(asStep(goal), []);
  state.known = goal;
  state.grasp = struct('position', there.position, 'arm', 1, 'yaw', 0.5);
  state = rememberFailure(state, {struct('kind', 'grasp'), struct('kind', 'follow'), struct('kind', 'open')});
  check(isempty(state.known), 'after a failed grasp the block is not where it was to go');
  check(isequal(state.failures, state.grasp), 'and the grasp is remembered');
  wide = block([0, 0, 1], [3, 2, 1], 0, -2, 0, 0);
  [~, reason] = planPickAndPlace(struct('opening', 2), wide, wide, noBlocks(), [], []);
  check(strcmp(reason, 'it is wider than the gripper opens'), 'a block that is too wide is not taken');
end
