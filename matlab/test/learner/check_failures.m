function check_failures()
  there = block([1, 0, 0], [1, 1, 1], 3, -2, 0, 0);
  goal = block([1, 0, 0], [1, 1, 1], 0, -2, 0, 0);
  state = initialTaskState(asStep(goal), []);
  state.known = goal;
  state.grasp = newGrasp(there.position, struct('index', 1), 0.5);
  state = rememberFailure(state, {struct('kind', 'grasp'), struct('kind', 'follow'), struct('kind', 'open')}, 'an obstacle');
  check(isempty(state.known), 'after a failed grasp the block is not where it was to go');
  check(isequal(state.failures, state.grasp), 'and the grasp is remembered');

  state.known = goal;
  state = rememberFailure(state, {struct('kind', 'lift'), struct('kind', 'open')}, cannotLift());
  arms = struct('index', {1, 2}, 'opening', 2, 'name', {'right', 'left'});
  is_too_heavy = arrayfun(@(arm) isTooHeavy(there, arm, state.failures), arms);
  check(isequal(is_too_heavy, [true, false]), 'what an arm could not lift is too heavy for it wherever it is');
  check(~isTooHeavy(block([0, 0, 1], [1, 1, 1], 3, -2, 0, 0), arms(1), state.failures), 'but not what looks different');
  [~, reason] = planPickAndPlace(arms(1), there, goal, noBlocks(), [], state.failures);
  check(strcmp(reason, 'it is too heavy to be lifted'), 'then no arm takes it');
  [able, reason] = ableArms(arms, there, 1, state.failures, '');
  is_other = isequal(able, arms(2)) && strcmp(reason, 'it is too heavy for the arm right, and no other one can do it');
  check(is_other, 'or only the other one, and if it cannot, the reason is the weight');
  state.failures(end).tooHeavy = block([1, 0, 0], [3, 0.5, 1], 0, -2, 0, 0);
  check(isTooHeavy(block([1, 0, 0], [3, 1, 0.5], 3, -2, 0, 0), arms(1), state.failures), 'what was turned in vain is too heavy on its other faces, too');
  check(~isTooHeavy(block([1, 0, 0], [3, 1, 1], 3, -2, 0, 0), arms(1), state.failures), 'but not what is larger');

  wide = block([0, 0, 1], [3, 2, 1], 0, -2, 0, 0);
  [~, reason] = planPickAndPlace(struct('opening', 2), wide, wide, noBlocks(), [], []);
  check(strcmp(reason, 'it is wider than the gripper opens'), 'a block that is too wide is not taken');
end
