function q = anglesAt(motion, time)
% The angles a motion wants some seconds after its start: it begins and ends gently.
  part = min(max(time / motion.duration, 0), 1);
  share = (1 - cos(pi * part)) / 2;
  place = 1 + share * (size(motion.angles, 1) - 1);
  i = min(floor(place), size(motion.angles, 1) - 1);
  q = motion.angles(i, :) + (place - i) * (motion.angles(i + 1, :) - motion.angles(i, :));
end
