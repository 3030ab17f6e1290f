function [best, alignment] = refinedAlignment(surface, alignment, pivot, picture, eye)
% Improves an alignment (see align) by small displacements, and turns about a pivot, 1x3 [units]. Returns the fraction of the
% points that look alike, and the alignment.
  c = constants().alignment;
  best = agreement(surface, alignment, picture, eye);
  step = 1;
  while step > c.finest
    before = best;
    for change = [diag([1, 1, 1]), -diag([1, 1, 1])] .* [c.shift; c.shift; c.turn_rad / 2] * step
      it = alignment;
      it.angle = alignment.angle + change(3);
      it.place = alignment.place + rotated(pivot(1:2), alignment.angle) - rotated(pivot(1:2), it.angle) + change(1:2)';
      share = agreement(surface, it, picture, eye);
      if share > best
        best = share;
        alignment = it;
      end
    end
    if best == before, step = step / 2; end
  end
end
