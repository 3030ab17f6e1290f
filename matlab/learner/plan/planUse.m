function [actions, state, problem] = planUse(use, alignment, surface, state, arms, sensor)
% Plans a use of a tool (see newPress): takes it, brings it to where it works, closes the gripper again, and puts it back. A
% 1xN cell of actions; {} and a problem if that is impossible. state.grasp is that of the tool.
%   alignment, surface  see align, surfaceOf
  actions = {};
  state.grasp = [];
  [k, tool] = findTool(use, state.known, surface, state.shown);
  problem = [use.tool.name, ' is not visible'];
  if isempty(k), return; end
  % Should it fail, the tool is no longer where it was.
  others = state.known([1:k - 1, k + 1:end]);
  state.known = [others, state.known(k)];
  is_tool = belongsTo(tool, surface.points);
  looks = surface.points(is_tool, :);
  around = surface.points(~is_tool, :);
  % On the straight way to its work, the tool passes as in the demonstration, and may touch what it changes.
  fixed = around(~isWithin(use.changed, alignment, around, state.shown), :);
  avoided = [surroundingsOf(around), surroundingsOf(fixed)];
  [able, problem] = ableArms(arms, state.known(end), tool.size(2), state.failures, 'no arm brings it there and back', use.tool.name);
  holds = toolHolds(nearestFirst(able, tool.position(1)), tool, others, state.failures);
  whole = wholeOf(looks, tool.position(3));
  loads = cell(size(holds));
  taken = loads;
  for it = waysFromSides(use, avoided(1))
    [begin, last, yaw] = seenFrom(use, it.side, alignment);
    begin = last + it.part * (begin - last);
    turn = yaw - tool.yaw;
    % All ways bring the tool there, whatever the hold.
    if ~isSkylineBelow(avoided(1).ofLoad, movedTo(whole, tool, begin, turn)), continue; end
    for k = 1:numel(holds)
      hold = holds(k);
      % It is planned once how the tool is taken, when that comes first.
      if isempty(loads{k})
        loads{k} = loadOf(whole, hold.poses{2});
        taken{k} = planToTake(hold, sensor.arms(hold.arm.index).joints(:)', boxAround(loads{k}));
      end
      if isempty(taken{k}), continue; end
      actions = planHeldUse(hold, taken{k}, loads{k}, tool, {begin, last}, turn, avoided, it.ways);
      if isempty(actions), continue; end
      state.grasp = hold.grasp;
      problem = '';
      return
    end
  end
end

function found = waysFromSides(use, around)
% Returns waysPast for each side from which what a use works on looks the same [rad], one way after the other, a 1xN struct array:
% all from the nearer sides before any from the others.
  sides = {0};
  if ~isempty(use.at), sides = constants().uses.sides_rad; end
  found = struct('part', {}, 'ways', {}, 'side', {});
  for some = sides(:)'
    for it = waysPast(around)
      for side = some{1}(:)', found(end + 1) = struct('part', it.part, 'ways', {it.ways}, 'side', side); end
    end
  end
end

function found = waysPast(around)
% Returns the ways there and back (see planThereAndBack) in the order in which they are tried, a 1xN struct array: first those
% beside what surroundings contain; where none is clear, those over all of it, as high as necessary. The part of the straight way
% to which they lead: what comes from above comes as close to its work as is clear, away from the robot.
  c = constants().uses;
  heights = max([0; around.ofLoad.heights(:)]) + c.heights_over';
  over = struct('is_line', false, 'height', num2cell(heights));
  found = struct('part', 1, 'ways', struct('is_line', {true, false}, 'height', {0, 0}));
  for part = c.parts_of_way', found(end + 1) = struct('part', part, 'ways', {over}); end
end
