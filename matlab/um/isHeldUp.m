function yes = isHeldUp(block, picture, eye, table)
% Whether a block may be where it seems to be: if the table, of a color, is seen right below all of the
% edge that is nearest to the eye, it is not so high up but larger and nearer to the table.
  c = constants().see;
  under = block.position - [0, 0, block.size(3) / 2 + c.below_edge];
  yes = under(3) < c.on_table;
  if yes, return; end
  way = eye.pose(1:2, 4)' - block.position(1:2);
  turns = round((atan2(way(2), way(1)) - block.yaw) / (pi / 2));  % from its first side to that edge
  toward = block.yaw + turns * pi / 2;
  half = circshift(block.size(1:2), turns) / 2;
  edge = under + half(1) * [cos(toward), sin(toward), 0];
  is_table = [];
  for share = c.edge_shares(:)'
    color = colorAt(picture, eye, edge + share * half(2) * [-sin(toward), cos(toward), 0]);
    if isempty(color), continue; end
    is_table(end + 1) = max(abs(color - table)) < c.table_tolerance;
  end
  yes = isempty(is_table) || ~all(is_table);
end
