function notes = planNotes(steps)
% Returns a note about each step: where its block goes in this scene.
  notes = asNote({}, {});
  for k = 1:numel(steps)
    step = steps(k);
    on = 'the table';
    if ~isempty(step.on), on = strjoin({steps(step.on).name}, ', '); end
    text = sprintf('%s at (%.2f, %.2f), on %s', describeStep(step), step.position(1:2), on);
    notes(end + 1) = asNote('plan', text, asBlocks(step));
  end
end
