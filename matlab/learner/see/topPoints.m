function points = topPoints(block)
% Returns the middle of a block's top and, unless it is a ball, points near its corners or its border, 5x3 or
% 1x3 [units]; of one with an outline, points inside that.
  points = block.position + [0, 0, block.size(3) / 2];
  if strcmp(block.form, 'ball'), return; end
  if ~isempty(block.outline)
    inside = rotated(block.outline.inside, block.yaw);
    points = points + [inside, zeros(rows(inside), 1)];
    return
  end
  fraction = constants().perception.top_fraction;
  if strcmp(block.form, 'disc'), fraction = fraction / sqrt(2); end
  along = fraction * block.size(1) * [cos(block.yaw), sin(block.yaw), 0];
  across = fraction * block.size(2) * [-sin(block.yaw), cos(block.yaw), 0];
  points = points + [0, 1, 1, -1, -1]' * along + [0, 1, -1, -1, 1]' * across;
end
