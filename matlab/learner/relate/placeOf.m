function fact = placeOf(block, around)
% Returns where an object is, as a fact (see factsAt): in the frame of the first of some others, or the table.
  away = block.position(1:2);
  yaw = block.yaw;
  reference = 'table';
  if ~isempty(around)
    reference = around(1).name;
    away = rotated(away - around(1).position(1:2), -around(1).yaw);
    yaw = yaw - around(1).yaw;
  end
  rounding = constants().relate.rounding;
  degrees = yaw * 180 / pi;
  degrees = degrees - 360 * floor((degrees + 180) / 360 + rounding);
  fact = sprintf('place %s %s%s %d', block.name, reference, hundredths(away), floor(degrees + 0.5 + rounding));
end
