function actions = retreat(arm, sensor)
% Lets go, goes up as high as possible, parks and looks again.
  park = postureOf(parkedAngles(arm), arm);
  up = postureOf(sensor.jointAngles(arm, :), arm);
  for height = linspace(park(3), up(3), 10)
    up(3) = height;
    if ~isempty(anglesFor(up, arm)), break; end
  end
  actions = {struct('kind', 'open', 'arm', arm), struct('kind', 'move', 'arm', arm, 'to', up), ...
             struct('kind', 'move', 'arm', arm, 'to', park), struct('kind', 'look')};
end
