function count = numPictures(picture)
% Returns of how many pictures like this one, HxWx3 from 0 to 1, the mean has little noise. Most neighboring
% pixels show the same surface and differ by noise only.
  c = constants().pictures;
  % Of the difference of two values with normally distributed noise of 1, half are below this.
  median_difference = 0.6745 * sqrt(2);
  differences = abs(diff(double(picture), 1, 2));
  noise = median(differences(:)) / median_difference;
  count = min(max(ceil((noise / c.max_noise) ^ 2), 1), c.max_pictures);
end
