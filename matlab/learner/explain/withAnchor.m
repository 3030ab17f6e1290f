function steps = withAnchor(demo, steps, others)
% Returns steps with their anchor, if nothing but their place was shown: an object was pushed, put beside another
% one, or exchanged. The anchor is the nearest object that nothing moved, whose step comes last, or the table.
%   others  steps of objects that the demonstration did not move
  if ~stoodFromTheStart(demo, steps), return; end
  anchor = 'the table';
  least = inf;
  for n = find(~ismember(demo.ids, {steps.name}))
    if ~isSamePose(demo.start(n, :), demo.final(n, :)), continue; end
    distance = min(vecnorm(vertcat(steps.position) - demo.final(n, 1:3), 2, 2));
    if distance < least, [least, anchor] = deal(distance, demo.ids{n}); end
  end
  [steps.anchor] = deal(anchor);
  for k = find(strcmp({others.name}, anchor)), steps(end + 1) = others(k); end
end
