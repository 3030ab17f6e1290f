function yes = sameForm(a, b)
% Returns true if two blocks, or kinds of blocks, have the same form, size and outline.
  yes = strcmp(a.form, b.form) && sameSize(a.size, b.size) && sameOutline(a.outline, b.outline);
end
