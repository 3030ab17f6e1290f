function moves = proposeMoves(building, k, free)
% What might be moved next to get step k done, the best first: a 1xN struct array of
%   block  number of a known block
%   goal   the step, or [] to put the block aside, where it disturbs nothing
%   free   numbers of the known blocks that are in no step's place
  moves = struct('block', {}, 'goal', {});
  step = building.steps(k);
  known = building.known;
  fits = free(arrayfun(@(i) isLike(known(i), step), free));
  in_way = free(overlap(gripRoom(step), footprint(known(free), 0)));
  walled = free(arrayfun(@(i) isWalledIn(known(i), building.steps), free));

  % First what will be hard to get at when more stands, and what looks right and is near.
  away = arrayfun(@(i) norm(known(i).position - step.position), fits);
  away(ismember(fits, [walled, in_way])) = 0;
  [~, order] = sort(away);
  fits = fits(order);
  for i = setdiff([in_way, walled], fits, 'stable'), moves(end + 1) = aside(i); end
  for i = intersect(in_way, fits(2:end)), moves(end + 1) = aside(i); end
  for i = fits
    if isempty(setdiff(in_way, i)), moves(end + 1) = struct('block', i, 'goal', step); end
  end
  % Then what lies on other blocks: what is wanted may be below it.
  for i = free
    if known(i).position(3) > known(i).size(3), moves(end + 1) = aside(i); end
  end
  % What something lies on waits for that.
  waits = arrayfun(@(move) ~isempty(whatLiesOn(move.block)), moves);
  moves(waits) = [];

  function on_top = whatLiesOn(i)
    higher = free(arrayfun(@(j) known(j).position(3) > known(i).position(3) + constants().decide.above, free));
    on_top = higher(overlap(footprint(known(i), 0), footprint(known(higher), 0)));
  end
end

function move = aside(i)
  move = struct('block', i, 'goal', []);
end
