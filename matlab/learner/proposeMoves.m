function moves = proposeMoves(state, k, free)
% Proposes the moves that may come next for step k, the best first: a 1xN struct array of
%   block  number of a known block
%   goal   the step, or [] for a temporary placement
% free contains the numbers of the known blocks that are in no step's place.
  moves = struct('block', {}, 'goal', {});
  step = state.steps(k);
  known = state.known;
  fits = free(arrayfun(@(i) isSameKind(known(i), step), free));
  obstructing = free(overlap(gripperClearance(step), footprint(known(free), 0)));
  blocked = free(arrayfun(@(i) isGraspBlocked(known(i), state.steps), free));

  % First the blocks that later steps make hard to reach, and the closest matching ones.
  distance = arrayfun(@(i) norm(known(i).position - step.position), fits);
  distance(ismember(fits, [blocked, obstructing])) = 0;
  [~, order] = sort(distance);
  fits = fits(order);
  for i = setdiff([obstructing, blocked], fits, 'stable'), moves(end + 1) = temporary(i); end
  for i = intersect(obstructing, fits(2:end)), moves(end + 1) = temporary(i); end
  for i = fits
    if isempty(setdiff(obstructing, i)), moves(end + 1) = struct('block', i, 'goal', step); end
  end
  % Then the blocks that lie on others: a matching block may be below them.
  for i = free
    bottom = known(i).position(3) - known(i).size(3) / 2;
    if bottom > constants().perception.on_table, moves(end + 1) = temporary(i); end
  end
  % A block with others on top has to wait.
  is_covered = arrayfun(@(move) hasObjectsOn(known(move.block), known(free)), moves);
  moves(is_covered) = [];
end

function move = temporary(i)
  move = struct('block', i, 'goal', []);
end
