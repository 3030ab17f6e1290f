function poses = uprightAtStart(poses)
% Returns the poses of an object, Nx6 as for restingAt, about axes of its own of which the third one is vertical at the
% start: an object that began on another face than its description's is told like one that began on its own.
  axes = rotationOf(poses(1, 4:6));
  [most, up] = max(abs(axes(3, :)));
  if up == 3 || most < cos(constants().task_model.max_rest_degrees * pi / 180), return; end
  along = min(setdiff(1:3, up));
  yaw = atan2(axes(2, along), axes(1, along)) * 180 / pi;
  own = axes' * rotationOf([0, 0, yaw]);
  for k = 1:size(poses, 1), poses(k, 4:6) = anglesOf(rotationOf(poses(k, 4:6)) * own); end
end

function angles = anglesOf(rotation)
% Returns the angles about x, then y, then z [degrees] of a rotation: see rotationOf.
  angles = [atan2(rotation(3, 2), rotation(3, 3)), -asin(max(-1, min(1, rotation(3, 1)))), ...
            atan2(rotation(2, 1), rotation(1, 1))] * 180 / pi;
end
