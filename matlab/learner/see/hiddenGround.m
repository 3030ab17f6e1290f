function hidden = hiddenGround(heights, eye)
% Returns the points of the table, in a grid, at which the eye sees something higher: Nx2 [units].
  c = constants().task_planning;
  [y, x] = ndgrid(nearEdge(eye) + (c.place_depth(1):c.place_depth(2):c.place_depth(3)), ...
                  c.place_x(1):c.place_x(2):c.place_x(3));
  hidden = [x(:), y(:)];
  pixels = pixelAt([hidden, zeros(numel(x), 1)], eye);
  inside = all(pixels >= 1 & pixels <= [size(heights, 2), size(heights, 1)], 2);
  hidden = hidden(inside, :);
  pixels = pixels(inside, :);
  hidden = hidden(heights(sub2ind(size(heights), pixels(:, 2), pixels(:, 1))) > constants().perception.on_table, :);
end
