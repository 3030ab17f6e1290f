function container = containerAt(containers, position)
% Returns the one of some containers, 1xN or [], that a position is in; [] if there is none.
  for container = containers
    if isInside(container, position), return; end
  end
  container = [];
end
