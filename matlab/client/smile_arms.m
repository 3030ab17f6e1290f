function result = smile_arms(command, varargin)
%SMILE_ARMS  The arms of AUX, SENSOR and MOTOR as struct arrays, and as the arrays of messages.
%
%   aux = smile_arms('describe', aux)       aux.arms(k): name, joints, limits, gripper, toolPose
%   arms = smile_arms('still', aux.arms)    commands of zero for motor.arms
%   sensor = smile_arms('sense', sensor, aux.arms)
%   motor = smile_arms('pack', motor, aux.arms)
%   values = smile_arms('posture', values, joints, aux.arms, field)
%   report = smile_arms('hint', report)     names what replaces a classic variable in its line
%
%   In messages, the joints of all arms follow one another. docs/brains.md describes the fields,
%   docs/brain-protocol.md the messages.

  switch command
    case 'describe', result = described(varargin{:});
    case 'still', result = still(varargin{:});
    case 'sense', result = sensed(varargin{:});
    case 'pack', result = packed(varargin{:});
    case 'posture', result = with_posture(varargin{:});
    case 'hint', result = with_hint(varargin{:});
  end
end

function aux = described(aux)
  names = regexp(aux.armNames, '\n', 'split');
  joints = regexp(aux.armJointNames, '\n', 'split');
  last = cumsum(aux.armJointCounts);
  first = last - aux.armJointCounts + 1;
  for k = 1:numel(names)
    own = first(k):last(k);
    arms(k) = struct('name', names{k}, 'joints', {joints(own)}, ...
                     'minJoints', aux.armMinJoints(own), 'maxJoints', aux.armMaxJoints(own), ...
                     'maxVelocities', aux.armMaxVelocities(own), ...
                     'gripper', without_nan(aux.armGrippers(:, k).'), ...
                     'toolPose', aux.armToolPoses(:, :, k));
  end
  aux = rmfield(aux, {'armNames', 'armJointCounts', 'armJointNames', 'armMinJoints', ...
                      'armMaxJoints', 'armMaxVelocities', 'armGrippers', 'armToolPoses'});
  aux.arms = arms;
end

function motor = still(arms)
  motor = struct('velocities', cell(1, numel(arms)), 'gripperVelocity', 0);
  for k = 1:numel(arms), motor(k).velocities = zeros(1, numel(arms(k).joints)); end
end

function sensor = sensed(sensor, arms)
  held = regexp(sensor.armHeldObjects, '\n', 'split');
  held(cellfun('isempty', held)) = {''};
  last = 0;
  for k = numel(arms):-1:1, states(k).joints = []; end
  for k = 1:numel(arms)
    own = last + 1:last + numel(arms(k).joints);
    last = own(end);
    states(k).joints = sensor.armJoints(own);
    states(k).velocities = sensor.armVelocities(own);
    states(k).gripper = without_nan(sensor.armGrippers(k));
    states(k).endEffector = sensor.armEndEffectors(:, :, k);
    states(k).heldObject = held{k};
  end
  sensor = rmfield(sensor, {'armJoints', 'armVelocities', 'armGrippers', 'armEndEffectors', ...
                            'armHeldObjects'});
  sensor.arms = states;
end

function motor = packed(motor, arms)
  commands = motor.arms;
  motor = rmfield(motor, 'arms');
  if isempty(arms)
    error('smile:value', ['arms is set, but the robot''s arms are described only to scripts ' ...
                          'that contain .arms']);
  end
  if ~isstruct(commands) || numel(commands) ~= numel(arms)
    error('smile:value', 'arms has %d elements, expected %d', numel(commands), numel(arms));
  end
  unknown = setdiff(fieldnames(commands), {'velocities', 'gripperVelocity', 'joints'});
  if ~isempty(unknown)
    error('smile:value', 'arms(k).%s is unknown, expected velocities, gripperVelocity or joints', ...
          unknown{1});
  end
  velocities = cell(numel(arms), 1);
  grippers = velocities;
  for k = 1:numel(arms)
    velocities{k} = ticks_of(commands, 'velocities', k, numel(arms(k).joints));
    grippers{k} = ticks_of(commands, 'gripperVelocity', k, 1);
  end
  velocities = stacked(velocities);
  grippers = stacked(grippers);
  if isfield(motor, 'jointVelocities')
    % A brain sets one of the two forms; the other one is left out if it is zero.
    is_set = size(velocities, 2) > 1 || size(grippers, 2) > 1 || any(velocities(:)) || ...
             any(grippers(:)) || (isfield(commands, 'joints') && ~isempty([commands.joints]));
    if ~is_set, return; end
    for name = {'jointVelocities', 'gripperVelocities'}
      if isfield(motor, name{1}) && ~any(motor.(name{1})(:)), motor = rmfield(motor, name{1}); end
    end
  end
  motor.armVelocities = velocities;
  motor.armGripperVelocities = grippers;
  if isfield(commands, 'joints')
    motor = with_posture(motor, {commands.joints}, arms, 'joints');
  end
end

function values = ticks_of(commands, field, k, count)
  % count x N numbers; one tick may also be a row.
  values = zeros(count, 1);
  if ~isfield(commands, field) || isempty(commands(k).(field)), return; end
  found = commands(k).(field);
  if isnumeric(found) && isreal(found) && ndims(found) == 2
    if size(found, 1) == count, values = full(double(found)); return; end
    if numel(found) == count, values = full(double(found(:))); return; end
  end
  if count == 1, expected = '1x1 or 1xN'; else, expected = sprintf('1x%d or %dxN', count, count); end
  refuse(field, k, found, expected);
end

function all = stacked(parts)
  % The last values of arms with fewer ticks remain in effect.
  ticks = max(cellfun('size', parts, 2));
  for k = 1:numel(parts)
    parts{k}(:, end + 1:ticks) = repmat(parts{k}(:, end), 1, ticks - size(parts{k}, 2));
  end
  all = vertcat(parts{:});
end

function values = with_posture(values, joints, arms, field)
  are_set = ~cellfun('isempty', joints(:));
  if ~any(are_set), return; end
  parts = cell(numel(arms), 1);
  for k = 1:numel(arms)
    count = numel(arms(k).joints);
    parts{k} = zeros(count, 1);
    if ~are_set(k), continue; end
    if ~isnumeric(joints{k}) || numel(joints{k}) ~= count
      refuse(field, k, joints{k}, sprintf('1x%d', count));
    end
    parts{k} = full(double(joints{k}(:)));
  end
  values.armJoints = vertcat(parts{:});
  values.armsAtJoints = double(are_set);
end

function refuse(field, k, found, expected)
  found = strjoin(cellfun(@num2str, num2cell(size(found)), 'UniformOutput', false), 'x');
  error('smile:value', 'arms(%d).%s is %s, expected %s', k, field, found, expected);
end

function value = without_nan(value)
  if any(isnan(value)), value = []; end
end

function report = with_hint(report)
  % The classic variables are for robots with two arms of seven joints.
  instead = {'sensor.jointAngles', 'sensor.arms(k).joints'
             'sensor.jointVelocities', 'sensor.arms(k).velocities'
             'sensor.gripperOpening', 'sensor.arms(k).gripper'
             'sensor.endEffPos', 'sensor.arms(k).endEffector'
             'sensor.isHolding', 'sensor.arms(k).heldObject'
             'sensor.heldObject', 'sensor.arms(k).heldObject'
             'aux.numLimbs', 'numel(aux.arms)'
             'aux.numJoints', 'numel(aux.arms(k).joints)'
             'aux.minJointAngles', 'aux.arms(k).minJoints'
             'aux.maxJointAngles', 'aux.arms(k).maxJoints'
             'aux.maxJointVelocities', 'aux.arms(k).maxVelocities'
             'motor.jointVelocities', 'motor.arms(k).velocities'
             'motor.gripperVelocities', 'motor.arms(k).gripperVelocity'
             'motor.jointAngles', 'motor.arms(k).joints'};
  file = fopen(report.file, 'r');
  if file < 0, return; end
  line = '';
  for k = 1:report.line, line = fgetl(file); end
  fclose(file);
  if ~ischar(line), return; end
  for k = 1:size(instead, 1)
    if isempty(strfind(line, instead{k, 1})), continue; end
    report.message = sprintf('%s; %s is for two arms of seven joints, use %s', report.message, ...
                             instead{k, 1}, instead{k, 2});
    return
  end
end
