function check_clearance()
  [a, b] = meshgrid((-20:20) / 40);
  share = [a(:), b(:)];
  one = [0.3, -0.2, 2.0, 0.7, 0.4];
  many = [5 * halton(200, 2) - 2.5, 5 * halton(200, 3) - 2.5, 0.5 + 2.5 * halton(200, 5), ...
          0.5 + 2.5 * halton(200, 7), 8 * halton(200, 11) - 4];
  answers = overlap(one, many);
  check(isequal(overlap([one; many(1, :)], many), [answers, overlap(many(1, :), many)]), 'or of several');
  for i = 1:rows(many)
    % Points lie up to 0.08 apart, so rectangles as much larger or smaller bracket the truth.
    if haveCommonPoint(one, many(i, :), share, -0.15), check(answers(i), 'these overlap'); end
    if ~haveCommonPoint(one, many(i, :), share, 0.15), check(~answers(i), 'these are apart'); end
  end
  check(sum(answers) > 30 && sum(~answers) > 30, 'both answers occur');

  red = [1, 0, 0];
  middle = block(red, [1, 1, 1], 0, -2, 0, 0);
  beside = [block(red, [1, 1, 1], -1.1, -2, 0, 0), block(red, [1, 1, 1], 1.1, -2, 0, 0)];
  before = block(red, [1, 1, 1], 0, -3.1, 0, 0);
  check(numel(graspYaws(middle, noBlocks())) == 4, 'a single cube can be grasped with four yaws');
  yaws = graspYaws(middle, beside);
  check(numel(yaws) == 2 && all(abs(cos(yaws)) < 1e-9), 'between two others in one direction');
  check(isempty(graspYaws(block(red, [4, 1, 1], 0, -3.1, 0, 0), middle)), 'and sometimes not at all');
  check(isGraspBlocked(middle, [beside, before]), 'with a third block in front, the grasp is blocked');
  check(~isGraspBlocked(middle, block(red, [1, 1, 1], 4, -2, 0, 0)), 'but not by a distant block');
end

function numbers = halton(count, base)
% Returns numbers between 0 and 1 of low discrepancy (Halton's sequence).
  numbers = zeros(count, 1);
  for i = 1:count
    share = 1;
    rest = i;
    while rest > 0
      share = share / base;
      numbers(i) = numbers(i) + share * mod(rest, base);
      rest = floor(rest / base);
    end
  end
end

function yes = haveCommonPoint(one, other, share, grow)
  c = cos(other(5));
  s = sin(other(5));
  points = (share .* (other(3:4) + grow)) * [c, s; -s, c] + other(1:2) - one(1:2);
  c = cos(one(5));
  s = sin(one(5));
  yes = any(all(abs(points * [c, -s; s, c]) <= (one(3:4) + grow) / 2, 2));
end
