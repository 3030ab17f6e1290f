function pictures = picturesOf(folder)
% Returns the pictures of a recording, a 1xN struct array: frame, file, and isStill, whether the scene was still then, so that
% the next frame needed no picture of its own.
  lines = regexp(fileread(fullfile(folder, 'frames.csv')), '[^\r\n]+', 'match');
  names = regexp(lines{1}, ',', 'split');
  fields = regexp(lines(2:end), ',', 'split');
  frames = cellfun(@(it) str2double(it{strcmp(names, 'frame')}), fields);
  images = cellfun(@(it) it{strcmp(names, 'image')}, fields, 'UniformOutput', false);
  has = ~cellfun(@isempty, images);
  if ~any(has), error('there are no pictures in %s', folder); end
  is_still = [~has(2:end), true];
  files = cellfun(@(image) fullfile(folder, image), images(has), 'UniformOutput', false);
  pictures = struct('frame', num2cell(frames(has)), 'file', files, 'isStill', num2cell(is_still(has)));
end
