function grasp = newGrasp(position, arm, yaw)
% Returns an attempt to take a block: the position of its center, 1x3 [units], the number of the arm, and the direction
% from finger to finger [rad]. tooHeavy: the block, if the arm could not lift it.
  grasp = struct('position', position, 'arm', arm.index, 'yaw', yaw, 'tooHeavy', []);
end
