function yes = arePathsValid(arm, paths, varargin)
% Returns true if an arm can follow paths, a 1xN cell, while it holds something: see isPathValid.
  yes = true;
  for path = paths, yes = yes && isPathValid(arm, path{1}, varargin{:}); end
end
