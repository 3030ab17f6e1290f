function note = asNote(word, text, expected, found, camera)
% Returns a note about the work, for people: a word that docs/brains.md defines, and a text about blocks (see
% noBlocks): where the learner expects or expected to see them, and where it saw them, in the picture of
% a camera; empty for the eye.
  if nargin < 3, expected = noBlocks(); end
  if nargin < 4, found = noBlocks(); end
  if nargin < 5, camera = ''; end
  note = struct('word', word, 'text', text, 'expected', {expected}, 'found', {found}, 'camera', camera);
end
