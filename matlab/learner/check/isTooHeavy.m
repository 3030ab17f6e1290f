function yes = isTooHeavy(block, arm, failures)
% Returns true if an arm could not lift a block that looks like this one, on whichever face.
%   failures  see newGrasp; [] for none
  withSortedSides = @(it) setfield(it, 'size', sort(it.size));
  yes = false;
  for it = failures
    yes = yes || (it.arm == arm.index && ~isempty(it.tooHeavy) && ...
                  isSameKind(withSortedSides(it.tooHeavy), withSortedSides(block)));
  end
end
