function yes = sameSize(a, b)
% Returns true if two sizes are equal within the accuracy of pictures.
  yes = max(abs(a ./ b - 1)) < constants().blocks.same_size;
end
