function [init, callback] = agentBehavior()
% Learner: rebuilds in a new scene what a demonstration shows (letters, towers, rows, bridges).
% docs/learner.md describes it.
% smile: imitates
  init = @learnerInit;
  callback = @learnerCallback;
end
