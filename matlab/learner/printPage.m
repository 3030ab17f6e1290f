function printPage(keyframes, goal)
% Says in sentences what an explanation (see explain) contains: a page for people.
  fprintf('At the start:\n');
  printFacts(keyframes(1).facts);
  for k = 2:numel(keyframes)
    means = '';
    if keyframes(k).isMeans, means = ' (only a means: nothing of it is kept)'; end
    fprintf('%d. %s%s. New:\n', k - 1, keyframes(k).deed, means);
    printFacts(keyframes(k).made);
  end
  fprintf('The goal, made and kept:\n');
  printFacts(goal);
end

function printFacts(facts)
% Prints a sentence for each object that facts are about.
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
  for k = 1:numel(names), fprintf('  %s is %s.\n', names{k}, phrases{k}); end
  if isempty(names), fprintf('  Nothing known.\n'); end
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
    case 'cut', phrase = ['cut with ', words{3}];
    otherwise, phrase = 'gone';
  end
end
