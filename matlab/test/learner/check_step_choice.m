function check_step_choice()
% A step for which others made room comes next until it is done. Which steps can be planned is given here.
  global possible tried
  eval(['function [actions, state, reason] = planStep(state, k, varargin), global possible tried; tried(end + 1) = k; ', ...
        'actions = {}; reason = ''blocked''; if any(possible == k), actions = {1}; end; end']);
  remove = onCleanup(@() clear('-f', 'planStep'));
  cube = [1, 1, 1];
  for k = 1:3, steps(k) = asStep(block([1, 0, 0], cube, 2 * k, -2, 0, 0)); end
  state = initialTaskState(steps, []);
  possible = 3;
  state = chosen(state, [1, 3], 1, 'the first');
  state = chosen(state, [1, 3], 3, 'another one if it is blocked');
  possible = [1, 3];
  state = chosen(state, [1, 3], 3, 'which goes on');
  state = chosen(state, 1, 1, 'until it is done');
  possible = [];
  state = chosen(state, [1, 3], [1, 1], 'or blocked, too');
  check(strcmp(state.firstFailure, [describeStep(steps(1)), ': blocked']), 'which is remembered');
end

function state = chosen(state, open, expected, claim)
  global tried
  tried = [];
  [~, state] = planOneOf(open, state, [], robotEye(), [], []);
  check(isequal(tried, expected), claim);
end
