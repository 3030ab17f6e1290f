function numbers = requiredBefore(needs, steps, k)
% Returns the numbers of the steps that must be done before step k and that it does not stand on; needs: see needsOf.
  numbers = zeros(1, 0);
  last = needs.releases{strcmp(needs.ids, steps(k).name)}(end);
  for i = setdiff(find(~[steps(1:k - 1).stays]), steps(k).on)
    if mustPrecede(needs, steps(i), last), numbers(end + 1) = i; end
  end
end
