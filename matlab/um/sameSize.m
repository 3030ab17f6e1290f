function yes = sameSize(a, b)
% Whether two blocks are equally large, as far as pictures can tell.
  yes = max(abs(a ./ b - 1)) < constants().blocks.same_size;
end
