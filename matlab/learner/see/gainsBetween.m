function gains = gainsBetween(shown, seen)
% Returns the factors of red, green and blue, 1x3, that make colors in one light, Nx3, to those in another one, Mx3: the
% factors that explain most of the latter; ones if no others explain clearly more. Not all need be the same things.
  c = constants().gains;
  gains = [1, 1, 1];
  most = max(c.min_advantage * sum(explainedBy(shown, seen, gains, c)), c.min_explained);
  is_changed = false;
  for color = shown(max(shown, [], 2) > c.bright, :)'
    for other = seen'
      [trial, is_light] = gainsOf(color', other', c);
      if ~is_light, continue; end
      number = sum(explainedBy(shown, seen, trial, c));
      if number > most
        most = number;
        gains = trial;
        is_changed = true;
      end
    end
  end
  if ~is_changed, return; end
  for k = 1:c.num_refinements, gains = refinedGains(shown, seen, gains, c); end
end

function [gains, is_light] = gainsOf(color, other, c)
% Returns the factors that make one color to another one, and whether they differ little enough. A channel that is dark
% or saturated has the mean factor of the others.
  is_clear = color > c.dark & other < c.saturated;
  known = other(is_clear) ./ color(is_clear);
  gains = [1, 1, 1] * (sum(known) / numel(known));
  gains(is_clear) = known;
  is_light = any(is_clear) && c.range(1) < min(gains) && max(gains) < min(c.range(2), c.max_tint * min(gains));
end

function [yes, nearest] = explainedBy(shown, seen, gains, c)
% Returns which of some seen colors are shown ones with some gains, 1xM logical, and the numbers of the nearest ones.
  away = max(abs(permute(brightened(shown, gains), [1, 3, 2]) - permute(seen, [3, 1, 2])), [], 3);
  [least, nearest] = min(away, [], 1);
  yes = least < c.same_color;
end

function gains = refinedGains(shown, seen, gains, c)
% Returns the gains that agree best with all colors that some gains explain.
  [yes, nearest] = explainedBy(shown, seen, gains, c);
  color = shown(nearest(yes), :);
  other = seen(yes, :);
  weights = color .* (other < c.saturated);
  total = sum(weights .* color, 1);
  is_known = total > 0;
  found = sum(weights .* other, 1);
  gains(is_known) = found(is_known) ./ total(is_known);
end
