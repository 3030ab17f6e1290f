function now = updateBeliefs(known, seen, picture, eye, heights)
% Returns the known blocks after a look at a picture.
  if nargin < 5, heights = []; end
  tolerance = constants().blocks.position_tolerance;
  now = corrected(seen, verdictsOn(known, seen, picture, eye, heights, tolerance));
end
