function actions = replaceDrive(robot, aside, sensor, aux)
% Returns the actions that replace the failed drive, where rack, bin and spare drive are seen.
  rack = findRack(sensor, aux);
  waste = findBin(sensor, aux);
  spare = findSpare(sensor, aux);
  for x = [-1.1, 1.1]  % the slots
    if ~strcmp(lampAt(x, rack, sensor, aux), 'failed'), continue, end
    slot = movedPlace(rack, x, 0.8);
    % The spare one stands alone: it may rise to 2.2 only on its way across. Each drive is carried when the actions before have ended: the planning of one then takes a step.
    actions = [look(@(s, a) switchTo('off', x, 1, 4, rack, robot, aside, s, a)), ...
               look(@(s, a) carryDrive(slot, 0.3, 2.2, waste, 0.15, robot, aside)), ...
               look(@(s, a) carryDrive(spare, 0, [2.2, 0.8], slot, 0.3, robot, aside)), ...
               look(@(s, a) switchTo('ready', x, -1, 4, rack, robot, aside, s, a))];
    return
  end
  disp('no drive has failed');
  actions = {};
end
