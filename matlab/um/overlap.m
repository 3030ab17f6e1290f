function yes = overlap(a, b)
% Whether two rectangles (see footprint) have points in common. If they have none, one of their sides
% has the direction of a line between them.
  yes = true;
  for yaw = [a.yaw, a.yaw + pi / 2, b.yaw, b.yaw + pi / 2]
    across = [cos(yaw), sin(yaw)];
    if abs((a.center - b.center) * across') >= reach(a, across) + reach(b, across)
      yes = false;
      return
    end
  end
end

function half = reach(rectangle, direction)
% How far it reaches from its center in a direction.
  c = cos(rectangle.yaw);
  s = sin(rectangle.yaw);
  half = rectangle.sides * abs([c, s; -s, c] * direction') / 2;
end
