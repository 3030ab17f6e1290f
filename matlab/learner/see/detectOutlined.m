function found = detectOutlined(picture, eye, color, kinds, heights)
% Detects the pieces of a color in a picture that look like given ones, on level ground, at any place and height: a 1xN struct array,
% see newBlock.
%   kinds    blocks or steps with an outline
%   heights  as from heightMap
  found = noBlocks();
  c = constants();
  number = labelRegions(colorMask(picture, color), heights);
  for region = find(accumarray(number(number > 0), 1) >= c.perception.min_top_pixels)'
    pixels = find(number == region);
    [row, column] = ind2sub(size(number), pixels);
    top = median(heights(pixels));
    if ~isLevel(heights(pixels)) || isCut(row, column, top, heights), continue; end
    [x, y, area] = ontoPlane(row, column, eye, top);
    outline = outlineOf(x, y, area);
    [yaws, misfits] = arrayfun(@(kind) outlineFit(kind.outline, outline), kinds);
    for k = find(misfits < c.outlines.misfit & misfits == min(misfits))
      kind = kinds(k);
      if top - kind.size(3) <= -c.perception.on_table, continue; end
      center = outline.center - rotated(kind.outline.center, yaws(k));
      found(end + 1) = newBlock(color, kind.size, [center, top - kind.size(3) / 2], yaws(k));
      found(end).outline = kind.outline;
      found(end).knob = kind.knob;
      found(end).otherKnobs = kind.otherKnobs;
    end
  end
end
