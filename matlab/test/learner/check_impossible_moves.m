function check_impossible_moves()
% What was found impossible is not tried again until something moves. Here nothing is possible.
  global count
  eval(['function [actions, place, why, reason] = planMove(varargin), global count; count = count + 1; ', ...
        'actions = {}; place = []; why = ''''; reason = ''no arm reaches it''; end']);
  remove = onCleanup(@() clear('-f', 'planMove'));
  state = initialTaskState(asStep(block([1, 0, 0], [1, 1, 1], 0, -2, 0, 0)), []);
  state.known = [block([1, 0, 0], [1, 1, 1], 3, -2, 0, 0), block([0, 0, 1], [1, 1, 1], 5, -4, 0, 0)];
  state = triedTimes(state, 1, 'a move is tried');
  check(strcmp(state.notes(end).text, 'impossible for now: step: no arm reaches it'), 'what is impossible is told');
  state = triedTimes(state, 0, 'and not tried again');
  state.known(2).position(2) = -3;
  triedTimes(state, 1, 'until something moves');
end

function state = triedTimes(state, expected, claim)
  global count
  count = 0;
  [actions, state, reason] = planStep(state, 1, 1:2, false, robotEye(), struct('opening', 2), []);
  check(isempty(actions) && strcmp(reason, 'no arm reaches it') && count == expected, claim);
end
