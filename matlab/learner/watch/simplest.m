function number = simplest(number, accuracy)
% Returns the multiple of the largest units that is a length within some accuracy; the length if none is.
  for units = constants().watching.units'
    multiples = units{1} .* round(number ./ units{1});
    [away, best] = min(abs(multiples - number));
    if multiples(best) <= 0 || away >= accuracy, continue; end
    number = multiples(best);
    return
  end
end
