function result = smile_arms(command, varargin)
%SMILE_ARMS  The arms of AUX and MOTOR as struct arrays, and as the arrays of messages.
%
%   aux = smile_arms('describe', aux)       aux.arms(k): name, joints, limits, gripper, toolPose
%   layout = smile_arms('layout', aux.arms) for SMILE_SENSE_ARMS and SMILE_PACK_ARMS
%   arms = smile_arms('still', aux.arms)    commands of zero for motor.arms
%   values = smile_arms('posture', values, joints, layout, field)   adds joints that are not empty
%   smile_arms('refuse', field, k, found, expected)                 an error about a shape
%   report = smile_arms('hint', report)     names what replaces a classic variable in its line
%
%   In messages, the joints of all arms follow one another. docs/brains.md describes the fields,
%   docs/brain-protocol.md the messages.

  switch command
    case 'describe', result = described(varargin{:});
    case 'layout', result = layout_of(varargin{:});
    case 'still', result = still(varargin{:});
    case 'posture', result = with_posture(varargin{:});
    case 'refuse', refuse(varargin{:});
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

function layout = layout_of(arms)
  % Where the values of each arm are, and what every step starts from.
  counts = cellfun('prodofsize', {arms.joints});
  last = cumsum(counts);
  layout.num_joints = last(end);
  layout.has_gripper = ~cellfun('isempty', {arms.gripper});
  for k = 1:numel(arms)
    layout.own{k} = last(k) - counts(k) + 1:last(k);
    layout.states(k) = struct('joints', [], 'velocities', [], 'gripper', [], 'endEffector', [], ...
                              'heldObject', '');
  end
  layout.fields = {'armJoints', 'armVelocities', 'armGrippers', 'armEndEffectors', ...
                   'armHeldObjects'};
end

function values = with_posture(values, joints, layout, field)
  are_set = ~cellfun('isempty', joints(:));
  if ~any(are_set), return; end
  parts = cell(numel(layout.own), 1);
  for k = 1:numel(layout.own)
    count = numel(layout.own{k});
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
