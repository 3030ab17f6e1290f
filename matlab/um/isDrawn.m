function yes = isDrawn(goal)
% Whether a goal, a step or only a place, is for something that is drawn there, not carried.
  yes = isfield(goal, 'way') && ~isempty(goal.way);
end
