function objects = turnedAbout(anchor, objects, rotation, block)
% Returns steps, or containers, as they are when an anchor is where a block is, after a rotation [rad].
  for k = 1:numel(objects)
    away = rotated(objects(k).position(1:2) - anchor.position(1:2), rotation);
    objects(k).position(1:2) = block.position(1:2) + away;
    objects(k).yaw = objects(k).yaw + rotation;
  end
end
