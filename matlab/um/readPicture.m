function picture = readPicture(demo, frame)
% One of a demonstration's pictures: HxWx3, 0 to 1; [] if there is none of this frame.
  found = glob(fullfile(demo.folder, '*', sprintf('%d.png', frame)));
  picture = [];
  if ~isempty(found), picture = double(imread(found{1})) / 255; end
end
