function yes = isSupported(block, picture, eye, table)
% Returns true if a block may be where it appears. If the table is visible right below all of the edge
% that is closest to the eye, the block is not so high up, but larger and closer to the table.
%   table  color of the table, 1x3
  c = constants().perception;
  below_bottom = block.position - [0, 0, block.size(3) / 2 + c.below_edge];
  yes = below_bottom(3) < c.on_table;
  if yes, return; end
  direction = eye.pose(1:2, 4)' - block.position(1:2);
  % From its first side to that edge.
  quarter_turns = round((atan2(direction(2), direction(1)) - block.yaw) / (pi / 2));
  toward = block.yaw + quarter_turns * pi / 2;
  half = circshift(block.size(1:2), quarter_turns) / 2;
  edge = below_bottom + half(1) * [cos(toward), sin(toward), 0];
  is_table = [];
  for fraction = c.edge_fractions(:)'
    color = colorAt(picture, eye, edge + fraction * half(2) * [-sin(toward), cos(toward), 0]);
    if isempty(color), continue; end
    is_table(end + 1) = max(abs(color - table)) < c.table_tolerance;
  end
  yes = isempty(is_table) || ~all(is_table);
end
