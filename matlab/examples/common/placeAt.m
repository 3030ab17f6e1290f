function place = placeAt(middle, depthAxis)
% Returns a place on the table: its middle (1x2), and the directions x of its width and y of its depth (1x3).
  place = struct('middle', middle, 'x', [depthAxis(2), -depthAxis(1), 0], 'y', [depthAxis, 0]);
end
