function moves = roomMoves(state, k, moves, free, arms, eye, sensor)
% Returns the moves that make room for the blocks of other moves, which have no free place on the table: a 1xN struct array,
% see newMove, for the first of those blocks for which some make it. As few as possible are put aside.
%   k     number of the step that comes next
%   free  numbers of the known blocks that are in no step's place
  % An empty list may lack the fields of moves.
  if isempty(moves), moves = noMoves(); return; end
  containers = asBlocks(state.containers);
  sites = {[asBlocks(state.steps), containers], [asBlocks(state.steps([find(state.done), k])), containers]};
  proposed = moves(cellfun(@isempty, {moves.turns}));
  moves = noMoves();
  is_loose = ~arrayfun(@(i) hasObjectsOn(state.known(i), state.known(free)), free);
  for move = proposed
    movable = setdiff(free(is_loose), move.block, 'stable');
    for site = sites
      [place, blocks] = roomFor(state, move, movable, site{1}, arms, eye, sensor);
      for i = blocks, moves(end + 1) = newMove(i, [], [], place); end
      if ~isempty(moves), return; end
    end
  end
end

function [place, blocks] = roomFor(state, move, movable, site, arms, eye, sensor)
% Returns a place for the block of a move on the table, and the numbers of those of some movable blocks that are in its way,
% 1xN; [] and 1x0 if there is none.
%   site  blocks to keep clear of, existing or planned
  c = constants().task_planning;
  known = state.known;
  block = known(move.block);
  fixed = [known(setdiff(1:numel(known), [move.block, movable])), assumedSupport(block)];
  left = noBlocks();
  if isempty(move.goal), left = [state.left, block]; end
  places = freePlacements(arms, eye, block, [fixed, site], move.goal, state.unexplained);
  covered = footprint(places, c.place_margin / 2);
  is_in_way = false(numel(places), numel(movable));
  for j = 1:numel(movable), is_in_way(:, j) = ~isFree(covered, known(movable(j))); end
  num_in_way = sum(is_in_way, 2)';
  is_possible = num_in_way > 0 & num_in_way <= c.max_put_aside;
  is_possible(is_possible) = ~arrayfun(@(place) isNear(place, left), places(is_possible));
  in_way = arrayfun(@(i) movable(is_in_way(i, :)), 1:numel(places), 'UniformOutput', false);
  places = places(is_possible);
  in_way = in_way(is_possible);
  [~, order] = sort(cellfun(@numel, in_way));
  num_tried = 0;
  for i = order
    place = places(i);
    blocks = in_way{i};
    others = withHeldParts([fixed, known(setdiff(movable, blocks, 'stable'))]);
    if ~isSuitable(place, arms, eye, others, site), continue; end
    if ~isempty(planToPlace(arms, block, place, others, sensor, move.goal, state.failures)), return; end
    num_tried = num_tried + 1;
    if num_tried == c.max_place_attempts, break; end
  end
  place = [];
  blocks = zeros(1, 0);
end
