function yes = avoidsTorso(arm, q)
% Returns true if joint angles of an arm, Nxn [rad], keep its upper arm away from the torso between the arms,
% which it would touch with its first joint at the limit that is farther from its parked angle.
  margin = constants().motion_planning.torso_margin_rad;
  if ~arm.hasTorso
    yes = true;
  elseif arm.parked(1) - arm.lower(1) > arm.upper(1) - arm.parked(1)
    yes = all(q(:, 1) > arm.lower(1) + margin);
  else
    yes = all(q(:, 1) < arm.upper(1) - margin);
  end
end
