function [init, callback] = agentBehavior()
% Replaces the fuse under a cover that four screws hold: the twin of python/examples/cover.
  init = @coverInit;
  callback = @coverCallback;
end
