function status = arrival(goal, q, delay)
% Returns 'done' if the joints have arrived at the goal of a path, 'busy' if they may yet, or why they do not.
%   delay  time since they should have [s]
  c = constants().execution;
  status = 'busy';
  if delay > 0 && max(abs(goal - q)) < c.joint_tolerance_rad
    status = 'done';
  elseif delay > c.max_delay_s
    status = 'an obstacle is in the way of the arm';
  end
end
