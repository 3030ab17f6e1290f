function q = samplesOf(path)
% Returns some of the joint angles along a path, Nxn [rad].
  step = max(floor(rows(path.positions) / constants().motion_planning.samples_per_path), 1);
  q = path.positions(1:step:end, :);
end
