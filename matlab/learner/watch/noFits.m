function fits = noFits()
% Returns an empty list of fits, a 1x0 struct array: see fitVisible.
  fits = struct('block', {}, 'kind', {}, 'seen', {}, 'certainty', {});
end
