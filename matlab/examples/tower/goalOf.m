function goal = goalOf(k, steps, seen, shoulders)
% Where the block of step k shall be: position of its top, and yaw, like a block from findBlock.
  if steps(k).support > 0
    below = seen{steps(k).support};
    c = cos(below.yaw);
    s = sin(below.yaw);
    offset = steps(k).offset * [c, s; -s, c];
    goal = struct('position', below.position + [offset, 1], 'yaw', below.yaw + steps(k).turn);
  elseif isGoodBase(k, seen, shoulders)
    goal = seen{k};  % it may stay where it is
  else
    goal = buildingPlace(k, seen);
  end
end

function yes = isGoodBase(k, seen, shoulders)
% Each other block must have an arm that reaches it and the top of the tower that is to stand here.
  above = seen{k}.position + [0, 0, numel(seen) - 1];
  yes = true;
  for i = [1:k - 1, k + 1:numel(seen)]
    if ~isempty(seen{i}) && armFor(seen{i}.position, above, numel(seen) - 1, shoulders) == 0
      yes = false;
    end
  end
end
