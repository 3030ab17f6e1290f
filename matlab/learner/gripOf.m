function grip = gripOf(x, y, pixel, color, height)
% Returns the part by which a piece is held, as a block in its frame: between the fingers all of the piece, within their width, ends
% on both sides. Flat ends, narrow places and those close to the center are preferred. [] if there is no such place.
%   x, y   points of its top in its frame, Nx1 [units]
%   pixel  side of the small square that each point stands for [units]
  c = constants().outlines;
  best = Inf;
  grip = [];
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
      if cost >= best - c.equal, continue; end
      best = cost;
      % So long that it is held across its width only.
      grip = newBlock(color, [c.bar * width, width, height], [rotated([place, middle], yaw), 0], yaw);
    end
  end
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
