function yes = mayBeBall(demo, n)
% Returns true unless object n of a demonstration was lower than at the start, where a ball lies on the table, or is of several
% shapes.
  heights = demo.moves(demo.moves(:, 2) == n, 5);
  yes = min(heights) >= heights(1) - constants().task_model.max_rest_error && ~hasShape(demo, n, 'composite');
end
