function block = measureTopWithKnob(demo, n, frames, pictures)
% Measures an object with a part in the middle of its top, like a lid with a knob, as a block at its first place;
% a 1x0 struct array if no picture shows the rest of its top. Its height is twice that of its middle where a hand
% put it lowest, on the table.
%   frames    as from selectFrames in measureObjects
%   pictures  of these frames
  block = noBlocks();
  if ~any(demo.placed == n), return; end
  height = 2 * min(demo.moves(demo.moves(:, 2) == n, 5));
  for row = frames'
    picture = pictures(row(1));
    if isempty(picture), continue; end
    for color = frequentColors(picture, constants().perception.min_rim_pixels)
      sides = sidesAround(picture, demo.eye, color', row(2:7)', height, constants().task_model.min_top_seen);
      if isempty(sides), continue; end
      block = newBlock(color', [sides, height], demo.start(n, 1:3), demo.start(n, 6) * pi / 180);
      block.hasKnob = true;
      return
    end
  end
end
