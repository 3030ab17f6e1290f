function [action, velocities, status] = followPath(action, sensor, aux)
% Follows a path until the measured joints have arrived, not until a fixed time. The velocities along the
% path, nxN, are chunks of N ticks. After its end, each tick has feedback. A lift ends where the arm does not keep up: what
% is too heavy is not dragged away.
  c = constants().execution;
  q = sensor.arms(action.arm.index).joints(:)';
  speed = speedOf(aux);
  delay = action.time - action.path.duration / speed;
  chunk = c.chunk_ticks;
  if strcmp(action.kind, 'lift'), chunk = c.lift_ticks; end
  num_ticks = min(ticksWithin(-delay, aux) + 1, chunk);
  % action.time is the end of the first of these ticks.
  wanted = smileSample(action.path, speed * (action.time + aux.tickSeconds * (0:num_ticks - 1)));
  velocities = diff([q; wanted]).' / aux.tickSeconds;
  status = arrival(action.path.positions(end, :), q, delay);
  if strcmp(action.kind, 'lift')
    expected = smileSample(action.path, speed * (action.time - aux.tickSeconds));
    if max(abs(expected - q)) > c.max_lag_rad, status = cannotLift(); end
  end
  if any(strcmp(status, {'done', cannotLift()})), velocities = zeros(numel(q), 1); end
end
