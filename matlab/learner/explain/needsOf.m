function needs = needsOf(aux, demo)
% Returns what of a demonstration its goal needs, and in which order, as smile analyze found out (aux.plan); [] without a
% plan, and for pictures alone, which show no segments. Segments are the numbers of the text files.
%   needs.goals       ids of the objects whose places count, cell
%   needs.sufficient  numbers of the subtasks that the goal needs
%   needs.firsts      the first segment of each subtask, 1xN
%   needs.before      (k, i): subtask i must come before subtask k, NxN logical
%   needs.releases    of each object of the demonstration, the segments in which it was released, cell
%   needs.ids         of these objects, cell
  needs = [];
  if ~isfield(aux, 'plan') || ~isfield(demo, 'segments'), return; end
  subtasks = aux.plan.subtasks;
  needs.goals = aux.plan.goals;
  needs.sufficient = aux.plan.sufficient;
  needs.firsts = arrayfun(@(it) it.segments(1), subtasks);
  needs.before = false(numel(subtasks));
  for pair = sortrows(aux.plan.order, 2)'
    needs.before(pair(2), :) = needs.before(pair(2), :) | needs.before(pair(1), :);
    needs.before(pair(2), pair(1)) = true;
  end
  released = demo.segments(strcmp({demo.events.word}, 'release'));
  needs.releases = arrayfun(@(n) released(demo.placed == n), 1:numel(demo.ids), 'UniformOutput', false);
  needs.ids = demo.ids;
end
