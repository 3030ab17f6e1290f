function notes = verdictNotes(verdicts, seen, steps, moved)
% Returns notes about verdicts (see verdictsOn): on the block that was just moved, the last one; on all others
% that are as expected, and that are hidden; and on each other one that is contradicted. Empty if nothing was
% moved and nothing is contradicted.
%   moved  name of the moved block; empty if nothing was moved
  notes = asNote({}, {});
  others = verdicts;
  if ~isempty(moved)
    notes(end + 1) = noteOn(verdicts(end), seen, moved);
    others(end) = [];
  end
  for word = {'as expected', 'hidden'}
    those = others(strcmp({others.word}, word{1}));
    if isempty(those), continue; end
    text = sprintf('%d other object', numel(those));
    if numel(those) > 1, text(end + 1) = 's'; end
    notes(end + 1) = asNote(word{1}, text, [those.expected], seen([those.found]));
  end
  wrong = others(strcmp({others.word}, 'contradicted'));
  for it = wrong, notes(end + 1) = noteOn(it, seen, nameOf(it.expected, steps)); end
  if isempty(moved) && isempty(wrong), notes = notes([]); end
end

function note = noteOn(verdict, seen, name)
% Returns a note about the verdict on a block of a name.
  text = 'something hides its top';
  if ~strcmp(verdict.word, 'hidden')
    text = 'it is not there';
    if ~isempty(verdict.found)
      it = seen(verdict.found);
      text = 'something else is there';
      if isSameKind(it, verdict.expected)
        text = sprintf('off by %.2f units and %.1f degrees', norm(it.position - verdict.expected.position), ...
                       180 / pi * abs(yawDifference(verdict.expected, it.yaw)));
      end
    end
  end
  note = asNote(verdict.word, [name, ': ', text], verdict.expected, seen(verdict.found));
end
