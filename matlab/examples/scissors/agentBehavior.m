function [init, callback] = agentBehavior()
% Cuts the string on which a weight hangs: the twin of python/examples/scissors.
  init = @scissorsInit;
  callback = @scissorsCallback;
end
