function [init, callback] = agentBehavior()
% Builds the tower that it was shown, in a scene it has never seen. docs/brains.md walks through it.
  init = @towerInit;
  callback = @towerCallback;
end
