function [folder, remove] = newRecording(pictures)
% Creates a folder for the texts of a recording, with these pictures; clearing `remove` deletes it.
  folder = tempname();
  mkdir(folder);
  mkdir(folder, 'rgb');
  remove = onCleanup(@() removeFolder(folder));
  for i = 1:numel(pictures)
    imwrite(uint8(255 * pictures{i}), fullfile(folder, 'rgb', sprintf('%d.png', i - 1)));
  end
  eye = robotEye();
  tilt = -(90 + 56.05) / 2 * pi / 180;
  info.meters_per_unit = 0.1;
  info.eye = struct('fx', eye.intrinsics(1, 1), 'fy', eye.intrinsics(2, 2), 'cx', 320, 'cy', 240, ...
                    'position_m', eye.pose(1:3, 4)' / 10, ...
                    'rotation_wxyz', [cos(tilt), sin(tilt), 0, 0]);
  write(folder, 'demo.json', {jsonencode(info)});
end

function removeFolder(folder)
  confirm_recursive_rmdir(false, 'local');
  rmdir(folder, 's');
end
