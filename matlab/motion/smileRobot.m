function robot = smileRobot(aux, base, unit, gripper)
%SMILEROBOT  Robot model for smileForward, smileInverse, smileMoveJoints, smileMoveLine, ...
%
%   robot = smileRobot(aux)                in a brain: the robot of aux, at its place
%   robot = smileRobot(file)               a URDF file; lengths in meters, the world is its base
%   robot = smileRobot(file, base, unit)   base 4x4, its pose in the world [units],
%                                          unit in meters per unit
%   robot = smileRobot(file, base, unit, gripper)   name of its gripper; '' for the default
%
%   robot.arms                                   names of the arms
%   robot.minJointAngles, robot.maxJointAngles   limits [rad; m], a row for each arm
%   robot.poses.untucked, ...                    named poses of the robot, likewise
%   If the arms have different numbers of joints, these are one row, arm after arm.
%
%   Lengths are in the scene's unit, angles in radians. A pose is 4x4, of the tool in the world: z is
%   the approach direction, y goes across the fingers. Baxter's arms are 'left' and 'right'; the arm
%   'both' means all arms.
  if nargin < 1, error('smileRobot: expected aux, or file, base, unit'); end
  if isstruct(aux)
    for name = {'robot', 'robotBase', 'unit'}
      if ~isfield(aux, name{1}), error('smileRobot: aux has no field %s', name{1}); end
    end
    file = aux.robot;
    base = aux.robotBase;
    unit = aux.unit;
    gripper = '';
    if isfield(aux, 'robotGripper'), gripper = aux.robotGripper; end
  else
    file = aux;
    if nargin < 2, base = eye(4); end
    if nargin < 3, unit = 1; end
    if nargin < 4, gripper = ''; end
  end
  robot = smilemotion('smileRobot', file, base, unit, gripper);
  robot.poses = cell2struct(robot.poseAngles, robot.poseNames, 2);
  robot = rmfield(robot, {'poseAngles', 'poseNames'});
end
