function yes = sameOutline(one, other)
% Returns true if two outlines (see outlineOf), or [], are equal in the frames of their objects.
  yes = isempty(one) && isempty(other);
  if isempty(one) || isempty(other), return; end
  c = constants().outlines;
  [turn, misfit] = outlineFit(one, other);
  if one.fold > 0, turn = turn - 2 * pi / one.fold * round(turn * one.fold / (2 * pi)); end
  yes = norm(one.center - other.center) < c.max_center_error && misfit < c.misfit && abs(turn) < c.max_turn_rad;
end
