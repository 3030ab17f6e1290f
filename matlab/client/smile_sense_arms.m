function sensor = smile_sense_arms(sensor, layout)
%SMILE_SENSE_ARMS  Converts the arrays of all arms in a step to the struct array sensor.arms.
%   LAYOUT is that of smile_arms('layout', aux.arms). Every step waits for this.
  persistent text held
  if ~strcmp(sensor.armHeldObjects, text)
    text = sensor.armHeldObjects;
    held = regexp(text, '\n', 'split');
    held(cellfun('isempty', held)) = {''};  % 0x0, as people write it
  end
  states = layout.states;
  for k = 1:numel(states)
    own = layout.own{k};
    states(k).joints = sensor.armJoints(own);
    states(k).velocities = sensor.armVelocities(own);
    if layout.has_gripper(k), states(k).gripper = sensor.armGrippers(k); end
    states(k).endEffector = sensor.armEndEffectors(:, :, k);
    states(k).heldObject = held{k};
  end
  sensor = rmfield(sensor, layout.fields);
  sensor.arms = states;
end
