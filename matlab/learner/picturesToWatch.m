function frames = picturesToWatch(folder)
% Selects the pictures of a recording to process, in order: all of them, or, if there are very many, those without
% motion (the next frame needed no picture of its own) and some of the others.
%   frames  1xN struct array with file and isQuiet
  max_moving = 150;
  lines = regexp(fileread(fullfile(folder, 'frames.csv')), '[^\r\n]+', 'match');
  images = regexprep(lines(2:end), '^[^,]*,[^,]*,', '');
  has = ~cellfun(@isempty, images);
  if ~any(has), error('there are no pictures in %s', folder); end
  is_quiet = has & [~has(2:end), true];
  which = find(has);
  which = which(is_quiet(which) | mod(1:numel(which), ceil(numel(which) / max_moving)) == 0);
  files = cellfun(@(image) fullfile(folder, image), images(which), 'UniformOutput', false);
  frames = struct('file', files, 'isQuiet', num2cell(is_quiet(which)));
end
