function yes = isInside(container, position)
% Whether a place is within the sides of a container; there is no place in [].
  yes = ~isempty(container) && overlap([position(1:2), 0, 0, 0], footprint(container, 0));
end
