function arm = armFor(from, to, highest, shoulders)
% The arm that can carry a block from one place to another, over all that is `highest` units high now:
% if possible the one on the block's side. 0 if neither can.
  arms = [1, 2];
  if from(1) > 0, arms = [2, 1]; end
  for arm = arms
    shoulder = shoulders(arm, :);
    if reaches(from, highest, shoulder, arm, 0.3) && ...
       reaches(to, max(highest, to(3)), shoulder, arm, 0)
      return
    end
  end
  arm = 0;
end

function yes = reaches(place, highest, shoulder, arm, most_lean)
% From above, too: the way down may lean by so many units.
  low = holdingPosture(place, 0, shoulder, arm);
  high = highPosture(place, 0, highest, shoulder, arm);
  yes = ~isempty(high) && high(2) - low(2) <= most_lean + 1e-6 && ~isempty(anglesFor(low, arm));
end
