function q = samplesOf(path)
% Returns the joint angles at evenly spaced times of a path, Nxn [rad], far from each other first: so what is in the way is found
% soon. (The path's own points may be only its ends.)
  c = constants().motion_planning;
  n = c.samples_per_path;
  q = smileSample(path, path.duration / (n - 1) * mod((0:n - 1) * c.sample_stride, n));
end
