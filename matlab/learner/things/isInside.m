function yes = isInside(container, position)
% Returns true if a position is between the sides of a container.
  yes = overlap([position(1:2), 0, 0, 0], footprint(container, 0));
end
