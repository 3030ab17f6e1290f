function [actions, attempt, problem] = planPress(press, alignment, surface, state, arms, sensor)
% Plans to press a button with closed fingers from above: a 1xN cell of actions, and the grasp that stands for the attempt;
% {} and a problem if that is impossible.
%   alignment, surface  see align, surfaceOf
  c = constants().presses;
  actions = {};
  attempt = [];
  problem = 'no button is visible';
  button = buttonOf(press, alignment, surface, state.shown);
  if isempty(button), return; end
  problem = 'no arm reaches it';
  others = withHeldParts(state.known);
  bottom = button.position(3) - button.size(3) / 2;
  for arm = nearestFirst(arms, button.position(1))
    for across = graspYaws(button, others)
      attempt = newGrasp(button.position, arm, across);
      if hasFailed(attempt, state.failures), continue; end
      down = toolPose(arm, [button.position(1:2), bottom + c.depth + arm.reach], across, 0);
      for height = c.heights'
        above = atHeight(down, blockTops(button) + height + arm.reach);
        path = planPathThrough(arm, {above, down, above}, others, sensor.arms(arm.index).joints(:)');
        if isempty(path), continue; end
        path(3) = [];  % a press goes back by itself
        moves = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
        moves{2}.kind = 'press';
        actions = [{struct('kind', 'open', 'arm', arm, 'to', 0)}, moves, {struct('kind', 'observe')}];
        problem = '';
        return
      end
    end
  end
  attempt = [];
end
