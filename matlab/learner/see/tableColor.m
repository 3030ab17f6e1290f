function color = tableColor(picture)
% Returns the color of the table, 1x3: the most frequent one except black, the background.
  step = constants().perception.table_pixel_step;
  pixels = reshape(round(255 * picture(1:step:end, 1:step:end, :)), [], 3) * [65536; 256; 1];
  most = mode(pixels(pixels > 0));
  color = [floor(most / 65536), mod(floor(most / 256), 256), mod(most, 256)] / 255;
end
