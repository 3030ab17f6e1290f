function yes = wasDragged(demo, n)
% Returns true if object n of a demonstration, of several shapes, like a door with a post, was only dragged, and never lifted or
% rotated. A single block that was pushed over the table may as well be carried. (Unknown without texts.)
  c = constants().task_model;
  moves = demo.moves(demo.moves(:, 2) == n, 3:8);
  yes = hasShape(demo, n, 'composite') && ~isempty(moves) && norm(moves(end, 1:2) - moves(1, 1:2)) > c.min_drag_distance && ...
        max(max(abs(moves(:, 3:6) - moves(1, 3:6)))) < c.max_drag_deviation;
end
