function [action, velocities, status] = pressAlong(action, sensor, aux)
% Follows a path to its end, or until something stops the arm, and back to its start: nx1 velocities. Each tick has feedback:
% an arm that pushes on slips off what it presses.
  c = constants().execution;
  if ~isfield(action, 'turn'), action.turn = Inf; end  % time at which it went back [s]
  q = sensor.arms(action.arm.index).joints(:)';
  time = speedOf(aux) * (action.time - [aux.tickSeconds, 0]);  % action.time is the end of this tick
  on_path = smileSample(action.path, min(time, 2 * action.turn - time));
  if isinf(action.turn) && (time(1) > action.path.duration || max(abs(on_path(1, :) - q)) > c.stall_rad)
    action.turn = time(1);
  end
  velocities = (on_path(2, :) - q)' / aux.tickSeconds;
  status = arrival(action.path.positions(1, :), q, time(2) - 2 * action.turn);
  if strcmp(status, 'done'), velocities = zeros(numel(q), 1); end
end
