function color = tableColor(picture)
% The table's is the most frequent color but black, which is where there is nothing.
  step = constants().see.table_pixel_step;
  pixels = reshape(round(255 * picture(1:step:end, 1:step:end, :)), [], 3) * [65536; 256; 1];
  most = mode(pixels(pixels > 0));
  color = [floor(most / 65536), mod(floor(most / 256), 256), mod(most, 256)] / 255;
end
