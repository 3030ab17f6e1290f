function work = newWork(actions)
% Returns the state of a program that carries out these actions; see stepWork.
  work = struct('actions', {actions}, 'began', [], 'moved', 0, 'opening', 0);
end
