function yes = hasFailed(grasp, failures)
% Returns true if a grasp (see newGrasp) is about the same as one that failed.
  c = constants().motion_planning;
  yes = false;
  for it = failures
    rotation = mod(grasp.yaw - it.yaw + pi, 2 * pi) - pi;
    yes = yes || (it.arm == grasp.arm && abs(rotation) < c.same_yaw_rad && ...
                  norm(it.position - grasp.position) < c.same_place_distance);
  end
end
