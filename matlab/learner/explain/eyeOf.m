function eye = eyeOf(folder)
% Reads the camera of a demonstration from its demo.json: intrinsics 3x3 [pixels] and pose 4x4 [units], as
% in aux.
  info = jsondecode(fileread(fullfile(folder, 'demo.json')));
  if ~isfield(info, 'eye') || isempty(info.eye)
    error(['the demonstration has no pictures, so that nothing shows how its objects look: record it ', ...
           'without --no-pictures']);
  end
  w = info.eye.rotation_wxyz;  % a unit quaternion
  v = [0, -w(4), w(3); w(4), 0, -w(2); -w(3), w(2), 0];  % v * x is the cross product with w(2:4)
  R = diag([1, 1, 1]) + 2 * w(1) * v + 2 * v * v;
  eye.intrinsics = [info.eye.fx, 0, info.eye.cx; 0, info.eye.fy, info.eye.cy; 0, 0, 1];
  eye.pose = [R, info.eye.position_m(:) / info.meters_per_unit; 0, 0, 0, 1];
end
