function [turn, misfit] = outlineFit(outline, found)
% Returns the rotation of an outline that makes another one of it [rad], and how much they differ then, as a fraction.
  c = constants().outlines;
  powers = c.powers(:)';
  misfit_of_size = max(abs(found.spread / outline.spread - 1), abs(sqrt(found.area / outline.area) - 1));
  turns = 0;
  if outline.fold > 0
    [~, strongest] = max(abs(outline.moments));
    k = powers(strongest);
    turns = angle(found.moments(strongest) / outline.moments(strongest)) / k + 2 * pi * (0:k - 1) / k;
    turns = turns - 2 * pi * round(turns / (2 * pi));
  end
  misfits = arrayfun(@(it) max([misfit_of_size, abs(found.moments .* exp(-1i * powers * it) - outline.moments)]), turns);
  % Of those that are equal within the accuracy of pictures, the first.
  best = find(misfits < min(misfits) + c.equal, 1);
  turn = turns(best);
  misfit = misfits(best);
end
