function eye = eyeOfRobot(aux)
% Returns the eye of a brain, and the table that it looks at: size of the table top along x and y [units].
  eye = struct('intrinsics', aux.cameraIntrinsics, 'pose', aux.cameraPose, 'table', aux.tableSize);
end
