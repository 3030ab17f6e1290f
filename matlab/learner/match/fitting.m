function fits = fitting(meant, k, fits, known)
% Returns those of some known blocks, numbers, of the kind of step k that it may use: the one that is meant, see
% meantBlocks; or all that no other step means, if that is not known.
  by = zeros(size(meant, 1), 0);
  for i = fits, by(:, end + 1) = isMeant(meant, known(i)); end
  if any(by(k, :)), fits = fits(by(k, :) == 1); else, fits = fits(~any(by, 1)); end
end
