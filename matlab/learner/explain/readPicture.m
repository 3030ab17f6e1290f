function picture = readPicture(demo, frame)
% Reads the picture of a frame of a demonstration: HxWx3, 0 to 1; [] if there is none.
  found = glob(fullfile(demo.folder, '*', sprintf('%d.png', frame)));
  picture = [];
  if ~isempty(found), picture = double(imread(found{1})) / 255; end
end
