function [init, callback] = agentBehavior()
% Replaces the failed drive of a rack by the spare one: the twin of python/examples/drive.
  init = @driveInit;
  callback = @driveCallback;
end
