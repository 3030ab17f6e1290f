function ways = pushWays(block, goal, others)
% Returns the straight ways along which a block can be pushed to a goal: up to four, one for each side, a 1xN struct array. At
% their starts, fingers have room between the block and what it touches at the goal.
%   goal    a block or a step
%   others  obstacles and supports, as blocks
%   ways    start, last  the block where the way begins, and at its goal
%           away         from the goal to the start, 1x2, of length 1
%           along, across  size of the block along the way and across it [units]
  c = constants().motion_planning;
  ways = struct('start', {}, 'last', {}, 'away', {}, 'along', {}, 'across', {});
  if isRound(block) || block.hasKnob || ~isempty(block.parts) || ~isempty(block.outline) || isDragged(goal), return; end
  last = asBlocks(block);
  last.position = goal.position;
  last.yaw = goal.yaw;
  isLevel = @(it) it.position(3) + it.size(3) / 2 > last.position(3) - last.size(3) / 2 + c.max_touching_gap && ...
                  it.position(3) - it.size(3) / 2 < last.position(3) + last.size(3) / 2;
  taken = footprint(others(arrayfun(isLevel, others)), -c.max_touching_gap);
  for k = 0:3
    away = [cos(goal.yaw + k * pi / 2), sin(goal.yaw + k * pi / 2)];
    start = last;
    start.position(1:2) = last.position(1:2) + c.push_distance * away;
    % Its middle is carried, also if it is a bit farther away.
    middle = start.position(1:2) + c.max_push_deviation * away;
    if any(overlap(taken, footprint(start, 0))) || ~isCarried(start, middle, others) || isempty(graspYaws(start, others))
      continue
    end
    sides = last.size(1 + [mod(k, 2), 1 - mod(k, 2)]);
    ways(end + 1) = struct('start', start, 'last', last, 'away', away, 'along', sides(1), 'across', sides(2));
  end
end

function yes = isCarried(block, point, others)
% Returns true if the table or another block is below a point of a block's bottom, 1x2 [units].
  below = others(arrayfun(@(it) standsOn(block, it), others));
  yes = block.position(3) - block.size(3) / 2 < constants().perception.on_table || ...
        any(overlap(footprint(below, 0), [point, 0, 0, 0]));
end
