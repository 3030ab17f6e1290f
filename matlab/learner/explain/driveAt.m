function drive = driveAt(demo, event, after, earlier, appearances)
% Returns all that a tool turned between its grasp and its release, to which the use of an event belongs: see newPress. What
% it changes may not be visible.
%   after    numbers of the steps that were done before it
%   earlier  the drives before it
  frames = graspFrames(demo);
  first = max(frames(frames < event.frame));
  last = min([frames(frames > event.frame), Inf]);
  uses = demo.events(strcmp({demo.events.word}, 'use') & [demo.events.frame] > first & [demo.events.frame] < last);
  name = uses(1).fields{2};
  n = find(strcmp(demo.ids, name));
  is_turning = all(arrayfun(@(it) any(strcmp(constants().uses.turning, it.fields{3})), uses));
  if ~any(toolsOf(demo) == n) || ~is_turning, notUnderstood('%s was not put back after its use on %s', name, uses(1).fields{4}); end
  what = arrayfun(@(it) strjoin(it.fields(3:4), ','), uses, 'UniformOutput', false);
  turns = struct('fastener', {}, 'place', {}, 'number', {}, 'isLoosening', {});
  for it = unique(what, 'stable'), turns(end + 1) = turnsOf(demo, n, uses(strcmp(what, it{1}))); end
  control = turns(1).fastener;
  for it = earlier
    if any(ismember({it.turns.fastener}, {turns.fastener}))
      control = it.control;
      break
    end
  end
  frames = pictureFrames(demo);
  picture = readPicture(demo, max(frames(frames <= first)));
  place = poseBefore(demo, find(strcmp(demo.ids, turns(1).fastener)), first);
  drive = newPress(control, after, picture, picture, maskAround(picture, demo.eye, place(1:3)));
  drive.tool = stepOf(demo, n, appearances(n), struct('object', {}, 'properties', {}));
  drive.turns = turns;
  of_tool = demo.moves(:, 2) == n & demo.moves(:, 1) > first & demo.moves(:, 1) <= uses(1).frame;
  drive.height = max(demo.moves(of_tool, 5));
end

function turns = turnsOf(demo, n, uses)
% Returns some uses of tool n on one fastener as turns. The tool rises and sinks with the fastener, and the last move before a
% use may be older than the way down: a hand that does not rise and sink holds it in the middle.
  name = uses(1).fields{4};
  other = find(strcmp(demo.ids, name));
  there = zeros(1, numel(uses));
  for k = 1:numel(uses)
    pose = poseBefore(demo, n, uses(k).frame + eps(uses(k).frame));
    there(k) = pose(3);
  end
  turned = poseBefore(demo, other, uses(1).frame + eps(uses(1).frame));
  before = poseBefore(demo, other, uses(1).frame);
  heights = [before(3) + there(1) - turned(3), there(1:end - 1)];
  place = poseBefore(demo, n, uses(1).frame);
  turns = struct('fastener', name, 'place', [place(1:2), (min(heights) + max(heights)) / 2], 'number', numel(uses), ...
                 'isLoosening', strcmp(uses(1).fields{3}, 'loosen'));
end
