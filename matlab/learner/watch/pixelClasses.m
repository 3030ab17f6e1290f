function classes = pixelClasses()
% Returns the numbers of the classes of pixels in a picture of a demonstration: background is the table and what is beyond it,
% unknown whatever is neither that nor of the color of a known object, like hands, sleeves and robots. Tops of color k are
% first + 2 (k - 1), and its darker shades, those of sides, one more.
  classes = struct('unknown', 1, 'background', 2, 'first', 4);
end
