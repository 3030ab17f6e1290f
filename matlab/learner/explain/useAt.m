function use = useAt(demo, event, after, appearances)
% Returns the use of a tool (see newPress) that a line of a demonstration describes. Its pictures are from before a hand
% took the tool, and from before a hand takes something again.
%   after        numbers of the steps that were done before it
%   appearances  as from measureObjects
  [name, action, target] = event.fields{2:4};
  if ~any(strcmp(constants().uses.actions, action)), notUnderstood('this learner cannot %s %s with %s', action, target, name); end
  n = find(strcmp(demo.ids, name));
  if ~any(toolsOf(demo) == n), notUnderstood('%s was not put back after its use on %s', name, target); end
  grasps = demo.events(strcmp({demo.events.word}, 'grasp'));
  frames = [grasps.frame];
  is_of_tool = arrayfun(@(it) strcmp(it.fields{2}, name), grasps);
  taken = max(frames(is_of_tool & frames < event.frame));
  taken_next = min([frames(frames > event.frame), Inf]);
  [before, later, changed] = changes(demo, taken, taken_next, target);
  use = newPress(target, after, before, later, changed);
  use.tool = stepOf(demo, n, appearances(n), struct('object', {}, 'properties', {}));
  rows = demo.moves(demo.moves(:, 2) == n & demo.moves(:, 1) <= event.frame, 3:8);
  use.pose = [rows(end, 1:3), use.tool.yaw + (rows(end, 6) - demo.final(n, 6)) * pi / 180];
  use.begin = straight(rows(:, 1:3));
  use.at = placeInChain(demo, event.frame, target);
end

function at = placeInChain(demo, frame, target)
% Returns where a chain was cut, 1x2: between the links that a target such as 'String between link 4 and 5' names; [] if it is
% something else.
  at = zeros(0, 2);
  parts = strsplit([target, ' between '], ' between ');
  links = strcat([parts{1}, '-link'], regexp(parts{2}, '\d+', 'match'));
  for n = find(ismember(demo.ids, links))
    places = demo.moves(demo.moves(:, 2) == n & demo.moves(:, 1) <= frame, 3:4);
    at(end + 1, :) = places(end, :);
  end
  if ~isempty(at), at = mean(at, 1); end
end

function begin = straight(places)
% Returns where the straight way of an object to the last of its places, Nx3, began.
  k = rows(places);
  while k > 1 && isOnWay(places(k - 1, :), places(k, :), places(end, :)), k = k - 1; end
  begin = places(k, :);
end

function yes = isOnWay(place, begin, last)
% Returns true if a straight way to an end may also have begun at an earlier place.
  whole = last - place;
  part = begin - place;
  deviation = norm(cross(whole, part)) / max(norm(whole), 1e-9);
  is_moved = max(abs(place - begin) - 1e-5 * abs(begin)) > 1e-8;
  yes = deviation < constants().uses.max_deviation && part * whole' > 0 && is_moved;
end
