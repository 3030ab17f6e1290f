function fit = bestFit(fits)
% Returns the fit (see fitVisible) of the greatest certainty; a 1x0 struct array if there is none, or more than one that hides
% something.
  fit = noFits();
  if isempty(fits), return; end
  fits = fits([fits.certainty] == max([fits.certainty]));
  if fits(1).certainty == 2
    [~, best] = min(abs([fits.seen] - 1));
    fit = fits(best);
  elseif isscalar(fits)
    fit = fits;
  end
end
