function block = withDepth(block, surface)
% Returns a block or step whose fingers stay above all that a surface (see surfaceOf) shows lower beside it; unchanged if the
% surface is [].
  if isempty(surface), return; end
  c = constants();
  near = [surface.points(:, 1:2), zeros(rows(surface.points), 3)];
  beside = footprint(block, c.clearance.open_fingers / 2 + c.clearance.margin);
  is_beside = overlap(beside, near) & ~overlap(footprint(block, c.perception.on_table), near);
  top = block.position(3) + block.size(3) / 2;
  lower = surface.points(is_beside & surface.points(:, 3) < top - c.perception.height_step, 3);
  if ~isempty(lower), block.depth = top - max(lower) - c.motion_planning.fingers_above_bottom; end
end
