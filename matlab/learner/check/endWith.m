function aux = endWith(claim, time, aux)
% Ends the run of a brain at a time [s] with a claim: done, true if everything is built, and reason, one line.
  if claim.done, word = 'done'; else, word = 'gave up'; end
  aux.claim = [word, ': ', claim.reason];
  fprintf('%5.1f s: %s\n', time, aux.claim);
  aux.exit = true;
end
