function yes = isSamePose(one, other)
% Returns true if two poses, 1x6 [units, degrees], are almost equal.
  c = constants().task_model;
  away = abs(one - other);
  yes = max(away(1:3)) < c.max_rest_error && max(away(4:6)) < c.max_rest_degrees;
end
