function parts = turnedParts(parts, angle)
% Returns parts (see measureParts) in the frame of an object that is turned by an angle [rad] from the present one.
  for k = 1:numel(parts)
    parts(k).position(1:2) = rotated(parts(k).position(1:2), -angle);
    parts(k).yaw = parts(k).yaw - angle;
  end
end
