function blocks = findBlocks(picture, eye, steps)
% The blocks in a picture that look like one of the steps', wherever they are: a 1xN struct array of
%   color, size  of the steps that it looks like
%   position     of its centre, 1x3 [units]
%   yaw          of its longer side [rad]
% A block of which something hides a part is not found.
  blocks = struct('color', {}, 'size', {}, 'position', {}, 'yaw', {});
  for color = colorsIn(picture, steps)
    kinds = kindsOf(steps, color');
    number = labelRegions(isColor(picture, color'));
    for region = 1:max(number(:))
      [row, column] = find(number == region);
      if numel(row) < 60, continue; end
      blocks = [blocks, fitBlock(row, column, eye, kinds)];
    end
  end
end
