function yes = isCut(row, column, top, heights)
% Returns true if something higher hides a part of a top face, or the border of the picture cuts it off: it
% touches pixels of higher surfaces.
%   row, column  pixels, Nx1
%   top          height of the face [units]
  c = constants().perception;
  edge = true(size(heights) + 2);
  edge(2:end - 1, 2:end - 1) = heights > top + c.height_step;
  beside = false(size(edge));
  for step = [0, 2, 1, 1; 1, 1, 0, 2]
    beside(sub2ind(size(edge), row + step(1), column + step(2))) = true;
  end
  yes = nnz(beside & edge) >= c.min_cut_pixels;
end
