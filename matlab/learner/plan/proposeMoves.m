function moves = proposeMoves(state, k, free)
% Proposes the moves that may come next for step k, the best first: a 1xN struct array, see newMove.
%   free  numbers of the known blocks that are in no step's place
  moves = noMoves();
  step = state.steps(k);
  known = state.known;
  fits = fitting(state.meant, k, free(arrayfun(@(i) isSameKind(known(i), step), free)), known);
  obstructing = free(overlap(gripperClearance(step), footprint(known(free), 0)));
  is_blocked = @(i) willBeBlocked(i, known, free, state.steps) && ~isAsideFor(state, k, known(i));
  blocked = free(arrayfun(is_blocked, free));

  % First the blocks that later steps make hard to reach, and the closest matching ones.
  distance = arrayfun(@(i) norm(known(i).position - step.position), fits);
  distance(ismember(fits, [blocked, obstructing])) = 0;
  [~, order] = sort(distance);
  fits = fits(order);
  if ~isempty(step.parts)
    % A thing of several colors is first taken from where it stood as high as in the demonstration.
    is_elsewhere = arrayfun(@(i) abs(known(i).position(3) - step.start(3)), fits) > constants().task_planning.max_sinking;
    [~, order] = sort(is_elsewhere & ~ismember(fits, [blocked, obstructing]));
    fits = fits(order);
  end
  for i = setdiff([obstructing, blocked], fits, 'stable'), moves(end + 1) = newMove(i); end
  for i = intersect(obstructing, fits(2:end)), moves(end + 1) = newMove(i); end
  for i = fits
    if isempty(setdiff(obstructing, i)), moves(end + 1) = newMove(i, step); end
  end
  % Then the blocks that lie on others: a matching block may be below them.
  for i = free
    bottom = known(i).position(3) - known(i).size(3) / 2;
    if bottom > constants().perception.on_table, moves(end + 1) = newMove(i); end
  end
  % A block with others on top has to wait.
  is_covered = arrayfun(@(move) hasObjectsOn(known(move.block), known(free)), moves);
  moves(is_covered) = [];
end

function yes = willBeBlocked(i, known, free, steps)
% Returns true if a known block, a number, lies where no fingers fit in once the steps are built: because of them alone, or
% of what touches it, too, although there is room now.
  steps = asBlocks(steps);
  others = known(free(free ~= i));
  beside = others(isBeside(others, known(i)));
  yes = isGraspBlocked(known(i), steps) || ...
        (~isempty(graspYaws(known(i), beside)) && isempty(graspYaws(known(i), [beside, steps])));
end

function yes = isAsideFor(state, k, block)
% Returns true if a block was put aside for step k: what it blocks there has to wait, as the step would otherwise.
  places = state.asides([state.asides.step] == k);
  yes = ~isempty(places) && isNear(block, [places.place]);
end
