function changes = colorChanges(wanted, seen)
% Returns how much each of some colors, Nx3, must have changed to look like each seen one, Mx3: NxM, the square of
% their distance, to which the hue contributes more than the brightness; Inf if it is too much.
  c = constants().light;
  changes = Inf(rows(wanted), rows(seen));
  for i = 1:rows(wanted)
    for k = 1:rows(seen)
      sizes = max([norm(wanted(i, :)), norm(seen(k, :))], c.darkest);
      hue = sum((wanted(i, :) / sizes(1) - seen(k, :) / sizes(2)).^2);
      change = hue + (c.brightness_weight * log(sizes(2) / sizes(1)))^2;
      if change < c.max_change, changes(i, k) = change; end
    end
  end
end
