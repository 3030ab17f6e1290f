function count = numPictures(noise)
% Returns of how many pictures with a noise, as from noiseOf, the mean has little.
  c = constants().pictures;
  count = min(max(ceil((noise / c.max_noise) ^ 2), 1), c.max_pictures);
end
