function [init, callback] = agentBehavior()
% The two scripts of this brain: one to begin with, one for every step.
  init = @waveInit;
  callback = @waveCallback;
end
