function yes = isInView(places, top, eye)
% Returns which of N places are entirely in the eye's picture: Nx1 logical.
%   places  Nx5 as from footprint
%   top     height of the top of a block there [units]
  yes = true(rows(places), 1);
  margin = constants().task_planning.picture_margin_pixels;
  corners = cornersOfPlaces(places);
  for k = 1:4
    pixels = toPixel([corners(:, :, k), repmat(top, rows(places), 1)], eye);
    yes = yes & all(pixels > margin & pixels < 2 * eye.intrinsics(1:2, 3)' - margin, 2);
  end
end
