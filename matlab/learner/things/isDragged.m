function yes = isDragged(goal)
% Returns true if a goal, a step or a place, is for an object that is dragged there, not carried.
  yes = isfield(goal, 'displacement') && ~isempty(goal.displacement);
end
