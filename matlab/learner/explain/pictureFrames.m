function frames = pictureFrames(demo)
% Returns the frames of a demonstration that have pictures, 1xN.
  files = glob(fullfile(demo.folder, '*', '*.png'));
  numbers = regexp(files, '(\d+)\.png$', 'tokens', 'once');
  frames = unique(cellfun(@(it) str2double(it{1}), numbers(~cellfun(@isempty, numbers))))';
end
