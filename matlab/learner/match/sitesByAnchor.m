function [sites, cost] = sitesByAnchor(steps, known, eye)
% Returns the sites at which known blocks are where steps stay: the steps at each, 1xN cell, and its cost, 1xN.
  anchor = steps(find([steps.stays], 1));
  sites = {};
  cost = [];
  if isempty(anchor), return; end
  turns = [0, 1, -1, 2] * pi / 2;
  if ~hasEqualSides(anchor), turns = [0, pi]; end
  for block = known(arrayfun(@(it) isSameKind(it, anchor), known))
    for rotation = yawDifference(anchor, block.yaw) + turns
      moved = turnedAbout(anchor, steps, rotation, block);
      is_there = areInPlace(known, moved([moved.stays]));
      if ~all(any(is_there, 2)), continue; end
      rest = known(~any(is_there, 1));
      turning = constants().building_site.rotated_cost * abs(rotation);
      cost(end + 1) = turning + siteCost(moved, rest, eye);
      sites{end + 1} = moved;
    end
  end
end
