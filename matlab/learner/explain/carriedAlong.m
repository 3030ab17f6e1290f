function numbers = carriedAlong(demo)
% Returns the numbers of the objects of a demonstration that were never held, but lifted on or in others: 1xN.
  numbers = [];
  for n = setdiff(1:numel(demo.ids), demo.placed)
    heights = demo.moves(demo.moves(:, 2) == n, 5);
    if max(heights) > heights(1) + constants().task_model.min_carried, numbers(end + 1) = n; end
  end
end
