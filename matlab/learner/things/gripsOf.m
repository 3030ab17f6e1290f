function grips = gripsOf(x, y, pixel, color, height)
% Returns the parts by which a piece can be held, the best first, as blocks in its frame, a 1xN struct array: between the fingers all
% of the piece, within their width, ends on both sides. Flat ends, narrow places and those close to the center are preferred; each
% further part is elsewhere, or held from another direction.
%   x, y   points of its top in its frame, Nx1 [units]
%   pixel  side of the small square that each point stands for [units]
  c = constants().outlines;
  grips = noBlocks();
  found = possibleGrips(x, y, pixel);
  while ~isempty(found) && numel(grips) < c.num_grips
    % Of those that are equal within the accuracy of pictures, the first.
    best = found(find([found.cost] < min([found.cost]) + c.equal, 1));
    % So long that it is held across its width only.
    grips(end + 1) = newBlock(color, [c.bar * best.width, best.width, height], [best.at, 0], best.yaw);
    found = found(arrayfun(@(it) isOther(it, best), found));
  end
end

function found = possibleGrips(x, y, pixel)
% Returns all places where the fingers may close on a piece, a 1xN struct array: at, in its frame, and width [units]; yaw, across the
% direction from finger to finger [rad]; cost.
  c = constants().outlines;
  found = struct('at', {}, 'yaw', {}, 'width', {}, 'cost', {});
  for yaw = (0:c.num_directions - 1) * pi / c.num_directions
    along = x * cos(yaw) + y * sin(yaw);
    across = y * cos(yaw) - x * sin(yaw);
    for place = c.cell * (ceil(min(along) / c.cell):floor(max(along) / c.cell))
      [lows, highs] = endsAt(along - place, across);
      if isempty(lows), continue; end
      width = max(highs) - min(lows) + pixel;
      middle = (max(highs) + min(lows)) / 2;
      uneven = max(highs) - min(highs) + max(lows) - min(lows);
      cost = width + c.uneven_cost * uneven + norm([place, middle]);
      found(end + 1) = struct('at', rotated([place, middle], yaw), 'yaw', yaw, 'width', width, 'cost', cost);
    end
  end
end

function yes = isOther(grip, than)
% Returns true if a grip is at another place than another one, or from another direction.
  c = constants().outlines;
  turn = mod(grip.yaw - than.yaw + pi / 2, pi) - pi / 2;
  yes = norm(grip.at - than.at) > c.other_place || abs(turn) > c.other_direction_rad;
end

function [lows, highs] = endsAt(along, across)
% Returns the lowest and the highest points across, in each third of the width of the fingers; [] if one has none.
  width = constants().outlines.finger;
  lows = [];
  highs = [];
  for third = [-1, 0, 1]
    points = across(abs(along - third * width / 3) <= width / 6);
    if isempty(points)
      lows = [];
      return
    end
    lows(end + 1) = min(points);
    highs(end + 1) = max(points);
  end
end
