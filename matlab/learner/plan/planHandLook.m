function [actions, state] = planHandLook(open, state, free, eye, arms, sensor)
% Plans to look at the largest part of the table that something hides from the eye, with a hand or after an arm moved aside, if a
% block that one of some steps needs is not known: a 1xN cell of actions; {} if there is no such part, or all were looked at before.
%   open  their numbers
%   free  numbers of the known blocks that are in no step's place
  c = constants().task_planning;
  actions = {};
  seeing = arms(~cellfun(@isempty, {arms.camera}));
  has_fit = @(k) any(arrayfun(@(i) isSameKind(state.known(i), state.steps(k)), free));
  if all(arrayfun(has_fit, open)) || rows(state.handLooks) >= c.max_hand_looks, return; end
  hidden = hiddenGround(heightMap(sensor.depthVision, eye), eye);
  hidden = hidden(~areCovered(hidden, state.known, 0), :);
  is_close = hypot(hidden(:, 1) - hidden(:, 1)', hidden(:, 2) - hidden(:, 2)') < c.hand_look_radius;
  [~, order] = sort(-sum(is_close, 2));
  hidden = hidden(order, :);
  for place = state.handLooks', hidden(vecnorm(hidden - place', 2, 2) < c.hand_look_radius, :) = []; end
  if isempty(seeing) && numel(sensor.arms) == 1
    [actions, state] = planLookAside(hidden, state, eye, arms, sensor);
    return
  end
  for place = hidden'
    place = place';
    for arm = nearestFirst(seeing, place(1))
      % The fingers are in the near half of the picture.
      height = max(c.hand_look_height, transferHeight(arm, state.known, 0, 0));
      over = toolPose(arm, [place - [0, c.hand_look_ahead], height], 0, 0);
      path = planPathThrough(arm, {over}, state.known, sensor.arms(arm.index).joints(:)');
      if isempty(path), continue; end
      state.handLooks(end + 1, :) = place;
      state.grasp = newGrasp(over(1:3, 4)', arm, 0);  % what fails if the arm is stopped: no grasp of a block
      text = sprintf('looks at (%.2f, %.2f), which something hides from the eye, with arm %s', place, arm.name);
      state.notes(end + 1) = asNote('action', text);
      actions = {struct('kind', 'follow', 'arm', arm, 'path', path{1}), struct('kind', 'look', 'arm', arm), ...
                 struct('kind', 'follow', 'arm', arm, 'path', path{2}), struct('kind', 'observe')};
      return
    end
  end
end
