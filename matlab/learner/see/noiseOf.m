function noise = noiseOf(picture)
% Returns the standard deviation of the noise of a picture, HxWx3 from 0 to 1. Most neighboring pixels show the same
% surface and differ by noise only. Of what is black or white, noise is cut off: it tells less of it.
  c = constants().pictures;
  % Of the difference of two values with normally distributed noise of 1, half are below this.
  median_difference = 0.6745 * sqrt(2);
  differences = abs(diff(picture, 1, 2));
  if median(differences(:)) > 0
    is_between = picture > c.saturated & picture < 1 - c.saturated;
    are_between = is_between(:, 2:end, :) & is_between(:, 1:end - 1, :);
    if sum(are_between(:)) >= c.min_unsaturated, differences = differences(are_between); end
  end
  noise = median(differences(:)) / median_difference;
end
