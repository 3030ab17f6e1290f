function text = hundredths(numbers)
% Returns numbers as text with two decimals, a blank before each, rounded alike in both twins.
  text = sprintf(' %.2f', floor(100 * numbers + 0.5 + constants().relate.rounding) / 100);
end
