function yes = sameForm(a, b)
% Returns true if two blocks, or kinds of blocks, have the same form and size.
  yes = strcmp(a.form, b.form) && sameSize(a.size, b.size);
end
