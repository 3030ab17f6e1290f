function [init, callback] = agentBehavior()
% Rebuilds what it was shown, in a scene it has never seen: letters, towers, rows, bridges.
% docs/learner.md walks through it.
% smile: imitates
  init = @umInit;
  callback = @umCallback;
end
