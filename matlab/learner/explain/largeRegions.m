function number = largeRegions(mask)
% Returns the numbers of the connected regions of a mask, HxW; 0 where it is false, and at thin rims, which change where
% something still moves a little.
  number = labelRegions(mask);
  sizes = accumarray(number(:) + 1, 1);
  number(sizes(number + 1) < constants().presses.min_changed_pixels) = 0;
end
