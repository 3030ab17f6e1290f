function check_making_room()
% As few blocks as possible make room for a large one. No robot is here: each place is suitable, and each plan possible.
  red = [1, 0, 0]; green = [0, 1, 0]; brown = [0.5, 0.3, 0.2];
  eval('function yes = isSuitable(varargin), yes = true; end');
  eval('function [actions, reason] = planToPlace(varargin), actions = {1}; reason = ''''; end');
  remove = onCleanup(@() clear('-f', 'isSuitable', 'planToPlace'));
  steps = [asStep(block(red, [1, 1, 1], 0, -2, 0, 0)), asStep(block(green, [1, 1, 1], 0, -2, 1, 0)), ...
           asStep(block(green, [1, 1, 1], -3, -2, 0, 0))];
  plank = block(brown, [5, 1, 1], -4, -0.2, 0, 0);
  cubes = noBlocks();
  for x = [-6, -3, 0, 3, 6]
    for y = [-4.5, -2.8, -1], cubes(end + 1) = block(green, [1, 1, 1], x, y, 0, 0); end
  end
  state = initialTaskState(steps, []);
  state.known = [plank, cubes];
  sites = asBlocks(steps);
  check(isempty(placesFor(plank, [cubes, sites])), 'there is no room');
  check(isempty(roomMoves(state, 1, newMove(1), 1, [], robotEye(), [])), 'nothing may be put aside');
  moves = roomMoves(state, 1, newMove(1), 1:numel(state.known), [], robotEye(), []);
  check(~isempty(moves) && all(cellfun(@isempty, {moves.goal})), 'others make room');
  in_way = [moves.block] - 1;
  rest = cubes(setdiff(1:numel(cubes), in_way));
  check(any(arrayfun(@(it) isequal(it.position, moves(1).room.position), placesFor(plank, [rest, sites]))), ...
        'then it is free');
  for i = in_way, check(isempty(placesFor(plank, [cubes(i), rest, sites])), 'each is in the way'); end
  clear remove;
  checkPlacesOnce();
end

function checkPlacesOnce()
% A place that failed is not tried again.
  red = [1, 0, 0];
  eval('function yes = canReach(varargin), yes = true; end');
  eval('function places = freePlacements(varargin), places = arrayfun(@(x) block([1, 0, 0], [1, 1, 1], x, -3, 0, 0), [4, -4]); end');
  eval('function [actions, reason] = planToPlace(arms, held, place, varargin), global tried; tried(end + 1) = place.position(1); actions = {}; reason = ''it slips''; end');
  remove = onCleanup(@() clear('-f', 'canReach', 'freePlacements', 'planToPlace'));
  global tried;
  tried = [];
  [actions, ~, reason] = planTemporaryPlacement([], robotEye(), block(red, [1, 1, 1], 5, -3, 0, 0), noBlocks(), ...
                                                {noBlocks(), noBlocks()}, [], [], [], noBlocks(), zeros(0, 2));
  check(isempty(actions) && strcmp(reason, 'it slips') && isequal(tried, [4, -4]), 'a place is tried once');
end

function places = placesFor(block, taken)
  places = freePlacements([], robotEye(), block, taken, [], zeros(0, 2));
end
