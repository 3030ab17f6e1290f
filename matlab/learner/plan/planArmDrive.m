function actions = planArmDrive(arm, tool, height, turns, q, isClear)
% Plans to take a tool, turn fasteners, and put the tool back, with one arm: a 1xN cell; {} if that arm cannot.
%   tool     the tool where it stands upright, a block
%   height   of its center on the way [units]
%   turns    see newPress, at their places in this scene
%   q        joint angles of the arm, 1xn [rad]
%   isClear  function of a path: whether nothing is in its way
  actions = {};
  for start = arm.starts'
    for depth = constants().uses.depths'
      hand = drivingHand(arm, tool.size(2), tool.size(3) / 2 - depth);
      take = pathsToTake(hand, tool, height, turns(1), start', q);
      if isempty(take), continue; end
      work = {};
      here = take{end}.positions(end, :);
      for turn = turns
        paths = pathsToTurn(hand, turn, height, here);
        if isempty(paths), break; end
        work{end + 1} = paths;
        here = paths{end}.positions(end, :);
      end
      if isempty(paths), continue; end
      put = pathsToPut(hand, tool, height, take, here);
      if isempty(put), continue; end
      across = [cellfun(@(it) it{1}, work, 'UniformOutput', false), put(1)];
      if ~all(cellfun(@(it) isPathValid(arm, it), [take, work{:}, put])) || ~all(cellfun(isClear, across)), continue; end
      actions = driveActions(hand, tool, turns, take, work, put);
      return
    end
  end
end

function actions = driveActions(hand, tool, turns, take, work, put)
% Returns the actions; work: the paths for each fastener.
  way = {};
  for k = 1:numel(turns)
    [~, ~, number] = strokesOf(hand, turns(k));
    way = [way, work{k}(1:2), repmat(work{k}(3:6), 1, number)];
  end
  follow = @(paths) cellfun(@(it) struct('kind', 'follow', 'arm', hand.arm, 'path', it), paths, 'UniformOutput', false);
  opening = min(hand.width + constants().motion_planning.opening_margin, hand.arm.opening);
  open = {struct('kind', 'open', 'arm', hand.arm, 'to', opening)};
  attempt = newGrasp(tool.position, hand.arm, 0);
  grasp = {struct('kind', 'grasp', 'arm', hand.arm, 'width', hand.width, 'grasp', attempt)};
  lift = {struct('kind', 'lift', 'arm', hand.arm, 'path', take{3})};
  actions = [open, follow(take(1:2)), grasp, lift, follow([way, put(1:3)]), open, follow(put(4:5)), ...
             {struct('kind', 'observe')}];
end
