function word = lampAt(x, rack, sensor, aux)
% Returns 'failed', 'ready' or 'off': the lamp of the slot at x of the rack.
  lamps = {'failed', [255 0 0]; 'ready', [32 208 64]};
  for k = 1:2
    word = lamps{k, 1};
    seen = insidePlace(rack, between(pointsOf(lamps{k, 2}, sensor, aux), 0.36, 0.5));
    if sum(max(abs(seen - [x, -1.3]), [], 2) < 0.7) > 20, return, end
  end
  word = 'off';
end
