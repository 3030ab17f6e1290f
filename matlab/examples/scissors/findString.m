function [place, legs] = findString(sensor, aux)
% Returns the place of the string, whose depth is the direction across it and away from the robot; and where it may be
% cut, left and right of the weight: x from its middle and height, a row for each.
  string = pointsOf([224 122 31], sensor, aux, true);
  if size(string, 1) < 100, error('no string is visible'); end
  [middle, axes] = rectangleAround(string);
  across = axes(2, :);
  if across(2) < 0, across = -across; end
  place = placeAt(middle, across);
  cut = between(string, 3.3, 3.7);
  xy = insidePlace(place, cut);
  left = xy(:, 1) < 0;
  legs = [mean(xy(left, 1)), mean(cut(left, 3)); mean(xy(~left, 1)), mean(cut(~left, 3))];
end
