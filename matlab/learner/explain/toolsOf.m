function tools = toolsOf(demo)
% Returns the numbers of the objects of a demonstration that were used as tools and put back where they began, 1xN.
  tools = zeros(1, 0);
  if ~isfield(demo, 'events'), return; end
  for event = demo.events(strcmp({demo.events.word}, 'use'))
    n = find(strcmp(demo.ids, event.fields{2}));
    if isSamePose(demo.start(n, :), demo.final(n, :)), tools = union(tools, n); end
  end
end
