function known = remember(known, seen, picture, eye)
% What is known of the blocks after a look: those seen, and those that were known before and may be
% hidden now, by what was built or by what lies on them. Where the table is seen, nothing is left.
  table = tableColor(picture);
  for block = known
    same = arrayfun(@(other) norm(other.position - block.position) < 0.5, seen);
    if any(same) || showsTable(picture, eye, block, table), continue; end
    seen(end + 1) = block;
  end
  known = seen;
end

function color = tableColor(picture)
% The table's is the most frequent color but black, which is where there is nothing.
  pixels = reshape(round(255 * picture(1:4:end, 1:4:end, :)), [], 3) * [65536; 256; 1];
  most = mode(pixels(pixels > 0));
  color = [floor(most / 65536), mod(floor(most / 256), 256), mod(most, 256)] / 255;
end

function yes = showsTable(picture, eye, block, table)
% At the middle of its top.
  spot = round(toPixel(block.position + [0, 0, block.size(3) / 2], eye) + 0.5);
  inside = all(spot >= 1 & spot <= [size(picture, 2), size(picture, 1)]);
  yes = inside && max(abs(reshape(picture(spot(2), spot(1), :), 1, 3) - table)) < 0.03;
end
