function [init, callback] = agentBehavior()
% Learner: rebuilds in a new scene what a demonstration shows (letters, towers, rows, bridges).
% docs/learner.md describes it, and what each folder here contains.
% smile: imitates
  addpath(genpath(fileparts(mfilename('fullpath'))));
  init = @learnerInit;
  callback = @learnerCallback;
end
