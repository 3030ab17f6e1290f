function steps = understandTower(demo)
% What was built, as a list of steps in the order of building. Each block has a step:
%   color    by which to find it
%   support  the number of the step whose block it stands on; 0 for a block on the table
%   offset   from the support's center to its own, along the support's sides [units]
%   turn     its yaw, seen from the support [rad]; only the angle modulo 90 degrees matters
% Blocks are cubes of one unit: the log tells no sizes.
  n = numel(demo.ids);
  support = zeros(1, n);
  for i = 1:n
    for j = 1:n
      if standsOn(demo.poses(i, :), demo.poses(j, :)), support(i) = j; end
    end
  end

  % First what others stand on and nothing carries; then what stands on something, in the order in
  % which it was let go for the last time, and where no hand did that, from the bottom upwards. A block
  % that stands alone is no part of the tower.
  bases = find(support == 0 & ismember(1:n, support));
  last = zeros(1, n);
  for k = 1:numel(demo.placed), last(demo.placed(k)) = k; end
  stacked = find(support > 0);
  [~, by_time] = sortrows([last(stacked)', demo.poses(stacked, 3)]);
  order = [bases, stacked(by_time)];
  if isempty(order), error('the demonstration ends with no block on another one'); end

  for k = 1:numel(order)
    steps(k) = describeStep(demo, order, k, support(order(k)));
  end
end

function yes = standsOn(upper, lower)
  gap = upper(1:3) - lower(1:3);
  yes = abs(gap(3) - 1) < 0.2 && norm(gap(1:2)) < 0.7;
end

function step = describeStep(demo, order, k, support)
  i = order(k);
  step = struct('color', demo.colors{i}, 'support', 0, 'offset', [0 0], 'turn', 0);
  if isempty(step.color), error('the demonstration names no color for %s', demo.ids{i}); end
  if support == 0, return; end
  step.support = find(order == support);
  if isempty(step.support) || step.support > k
    error('%s was placed before what it stands on', demo.ids{i});
  end
  support_yaw = demo.poses(support, 6) * pi / 180;
  gap = demo.poses(i, 1:2) - demo.poses(support, 1:2);
  step.offset = gap * [cos(support_yaw), -sin(support_yaw); sin(support_yaw), cos(support_yaw)];
  step.turn = quarterTurn(demo.poses(i, 6) * pi / 180 - support_yaw);
end
