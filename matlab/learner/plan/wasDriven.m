function yes = wasDriven(drive, state)
% Returns true if an arm did all of a drive, as far as it could tell: what it changes may not be visible. Its tool stands where
% it was again.
  yes = drive.attempts > 0 && any(arrayfun(@(it) isSameKind(it, drive.tool), state.known)) && ...
        ~any(arrayfun(@(it) isequal(rmfield(it, 'tooHeavy'), rmfield(drive.grasp, 'tooHeavy')), state.failures));
end
