function page = printPage(keyframes, goal, unclear)
% Says in sentences what an explanation (see explain) contains: a page for people. Returns its lines, 1xN cell.
%   unclear  what was not understood, in words, 1xN cell; omitted for nothing
  if nargin < 3, unclear = {}; end
  page = [{'At the start:'}, sentencesOn(keyframes(1).facts)];
  for k = 2:numel(keyframes)
    means = '';
    if keyframes(k).isMeans, means = ' (only a means: nothing of it is kept)'; end
    page = [page, {sprintf('%d. %s%s. New:', k - 1, keyframes(k).deed, means)}, sentencesOn(keyframes(k).made)];
  end
  page = [page, {'The goal, made and kept:'}, sentencesOn(goal)];
  for it = unclear, page{end + 1} = ['Not understood: ', it{1}, '.']; end
  fprintf('%s\n', page{:});
end

function sentences = sentencesOn(facts)
% Returns a sentence for each object that facts are about.
  names = {};
  phrases = {};
  for k = 1:numel(facts)
    words = strsplit(facts{k}, ' ');
    words(strcmp(words, 'table')) = {'the table'};
    which = find(strcmp(names, words{2}));
    if isempty(which)
      names{end + 1} = words{2};
      phrases{end + 1} = phraseOf(words);
    else
      phrases{which} = [phrases{which}, ', ', phraseOf(words)];
    end
  end
  sentences = strcat({'  '}, names, {' is '}, phrases, {'.'});
  if isempty(names), sentences = {'  Nothing known.'}; end
end

function phrase = phraseOf(words)
% Returns a fact without its subject, in words.
  switch words{1}
    case {'on', 'in', 'beside'}, phrase = [words{1}, ' ', words{3}];
    case 'held', phrase = ['in ', words{3}];
    case 'aligned', phrase = ['aligned with ', words{3}];
    case 'place', phrase = sprintf('at (%s, %s) of %s, rotated by %s degrees', words{[4, 5, 3, 6]});
    case 'joint', phrase = sprintf('dragged by (%s, %s)', words{3:4});
    case 'state', phrase = ['in state ', words{3}];
    case 'fastened', phrase = ['fastened to ', words{3}];
    case 'turned', phrase = 'turned onto another face';
    case 'cut', phrase = ['cut with ', words{3}];
    otherwise, phrase = 'gone';
  end
end
