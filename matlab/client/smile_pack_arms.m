function motor = smile_pack_arms(motor, layout)
%SMILE_PACK_ARMS  Replaces motor.arms by the arrays of all arms for the message.
%   LAYOUT is that of smile_arms('layout', aux.arms), or [] if the arms were not described. Every
%   step waits for this, so what is usual, one row of numbers for each arm, has no function calls.
  commands = motor.arms;
  motor = rmfield(motor, 'arms');
  has = check(commands, layout);
  num_arms = numel(layout.own);
  velocities = zeros(layout.num_joints, 1);
  grippers = zeros(num_arms, 1);
  is_usual = has(1) && has(2);
  for k = 1:num_arms
    if ~is_usual, break; end
    rates = commands(k).velocities;
    rate = commands(k).gripperVelocity;
    is_usual = isa(rates, 'double') && isreal(rates) && numel(rates) == numel(layout.own{k}) && ...
               isa(rate, 'double') && isreal(rate) && numel(rate) == 1;
    if is_usual
      velocities(layout.own{k}) = rates;
      grippers(k) = rate;
    end
  end
  if ~is_usual, [velocities, grippers] = of_ticks(commands, layout); end
  if isfield(motor, 'jointVelocities')
    % A brain sets one of the two forms; the other one is left out if it is zero.
    is_set = size(velocities, 2) > 1 || size(grippers, 2) > 1 || any(velocities(:)) || ...
             any(grippers(:)) || (has(3) && ~isempty([commands.joints]));
    if ~is_set, return; end
    for name = {'jointVelocities', 'gripperVelocities'}
      if isfield(motor, name{1}) && ~any(motor.(name{1})(:)), motor = rmfield(motor, name{1}); end
    end
  end
  motor.armVelocities = velocities;
  motor.armGripperVelocities = grippers;
  if has(3), motor = smile_arms('posture', motor, {commands.joints}, layout, 'joints'); end
end

function has = check(commands, layout)
  if isempty(layout)
    error('smile:value', ['arms is set, but the robot''s arms are described only to scripts ' ...
                          'that contain .arms']);
  end
  if ~isstruct(commands) || numel(commands) ~= numel(layout.own)
    error('smile:value', 'arms has %d elements, expected %d', numel(commands), numel(layout.own));
  end
  known = {'velocities', 'gripperVelocity', 'joints'};
  has = isfield(commands, known);
  names = fieldnames(commands);
  if numel(names) == sum(has), return; end
  names = names(~ismember(names, known));
  error('smile:value', 'arms(k).%s is unknown, expected velocities, gripperVelocity or joints', ...
        names{1});
end

function [velocities, grippers] = of_ticks(commands, layout)
  % Of one tick or more; missing values are zero.
  velocities = cell(numel(commands), 1);
  grippers = velocities;
  for k = 1:numel(commands)
    velocities{k} = ticks_of(commands, 'velocities', k, numel(layout.own{k}));
    grippers{k} = ticks_of(commands, 'gripperVelocity', k, 1);
  end
  velocities = stacked(velocities);
  grippers = stacked(grippers);
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
  smile_arms('refuse', field, k, found, expected);
end

function all = stacked(parts)
  % The last values of arms with fewer ticks remain in effect.
  ticks = max(cellfun('size', parts, 2));
  for k = 1:numel(parts)
    parts{k}(:, end + 1:ticks) = repmat(parts{k}(:, end), 1, ticks - size(parts{k}, 2));
  end
  all = vertcat(parts{:});
end
