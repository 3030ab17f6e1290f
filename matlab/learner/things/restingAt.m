function [sides, yaw] = restingAt(appearance, pose)
% Returns the sides and the yaw of an object at a pose, 1x6 [units, degrees], as a block that stands upright: of its
% own axes, the one that is vertical there becomes that of its height. Things of several colors count as upright: their parts
% are known from above only, and so are other outlines.
%   appearance  as from measureObjects: its sides along its own axes
  sides = appearance.size;
  yaw = pose(6) * pi / 180;
  axes = rotationOf(pose(4:6));  % its columns are those of the object
  [most, up] = max(abs(axes(3, :)));
  is_leaning = most < cos(constants().task_model.max_rest_degrees * pi / 180);
  if up == 3 || is_leaning || isRound(appearance) || ~isempty(appearance.parts) || ~isempty(appearance.outline), return; end
  others = setdiff(1:3, up);
  sides = sides([others, up]);
  yaw = atan2(axes(2, others(1)), axes(1, others(1)));
end
