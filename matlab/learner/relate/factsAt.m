function facts = factsAt(demo, appearances, containers, frame, held, others)
% Relates the objects of a demonstration: facts before an action of a frame, rows of words, 1xN cell, in the
% order of the objects.
%   on A B           A stands on B, or on the table
%   in A B           A is between the walls of the container B
%   beside A B       A and B are side by side, with no room for a finger between them
%   aligned A B      A, on or beside B, is parallel to it
%   held A HAND      a hand holds A
%   place A B x y r  A is at x, y [units], rotated by r [degrees], in the frame of B: what it stands on, the
%                    nearest object that is never moved, or the table; inside a container, of that
%   joint A x y      A was dragged by x, y [units] from where it began
%   state C S        the control C is in state S
%   fastened A B     B is fastened to A
%   cut A B          A was cut with the tool B
%   gone A           A is no longer there
%   turned A         A is on another face than at the start
%
%   appearances  as from measureObjects
%   containers   as from measureContainers
%   held         number of the object in each hand, a struct
%   others       facts about controls and joints at that time
  facts = others;
  there = {};  % all objects that rest: blocks with their names, and whether hands ever move them
  hands = fieldnames(held);
  in_hands = cellfun(@(hand) held.(hand), hands);
  for n = 1:numel(demo.ids)
    name = demo.ids{n};
    if any(strcmp(others, ['gone ', name])), continue; end
    pose = poseOf(demo, n, frame);
    if any(in_hands == n)
      facts{end + 1} = sprintf('held %s %s', name, hands{find(in_hands == n, 1)});
    elseif wasDragged(demo, n)
      facts{end + 1} = sprintf('joint %s%s', name, hundredths(pose(1:2) - demo.start(n, 1:2)));
    elseif ~isempty(appearances(n).size)
      [sides, yaw] = restingAt(appearances(n), pose);
      if ~sameSize(sides, appearances(n).size), facts{end + 1} = ['turned ', name]; end
      there{end + 1} = appearances(n);
      there{end}.size = sides;
      there{end}.position = pose(1:3);
      there{end}.yaw = yaw;
      there{end}.name = name;
      there{end}.moves = any(demo.placed == n);
    end
  end
  there = [there{:}];
  for k = 1:numel(there), facts = [facts, relations(k, there, containers)]; end
end

function facts = relations(k, there, containers)
% Returns the facts about object number k of those that are there.
  block = there(k);
  numbers = 1:numel(there);
  below = numbers(arrayfun(@(it) standsOn(block, it), there) & numbers ~= k);
  beside = numbers(arrayfun(@(it) isBeside(block, it), there) & numbers > k);
  facts = arrayfun(@(it) sprintf('on %s %s', block.name, it.name), there(below), 'UniformOutput', false);
  if ~isempty(containers), containers = containers(~strcmp({containers.name}, block.name)); end
  container = containerAt(containers, block.position);
  if ~isempty(container) && standsOn(block, container)
    facts{end + 1} = sprintf('on %s %s', block.name, container.name);
  elseif ~isempty(container)
    facts{end + 1} = sprintf('in %s %s', block.name, container.name);
  elseif isempty(below) && block.position(3) - block.size(3) / 2 < constants().task_model.max_support_gap
    facts{end + 1} = sprintf('on %s table', block.name);
  end
  for it = there(beside), facts{end + 1} = sprintf('beside %s %s', block.name, it.name); end
  for it = there([below, beside])
    if isAligned(block, it), facts{end + 1} = sprintf('aligned %s %s', block.name, it.name); end
  end
  if ~block.moves, return; end
  still = there(~[there.moves]);
  distances = arrayfun(@(it) norm(it.position(1:2) - block.position(1:2)), still);
  [~, order] = sort(distances);
  around = [there(below), still(order)];
  if ~isempty(container)
    around = struct('name', container.name, 'position', container.position, 'yaw', container.yaw);
  end
  facts{end + 1} = placeOf(block, around);
end
