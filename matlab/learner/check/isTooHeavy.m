function yes = isTooHeavy(block, arm, failures)
% Returns true if an arm could not lift a block that looks like this one.
%   failures  see newGrasp; [] for none
  yes = false;
  for it = failures
    yes = yes || (it.arm == arm.index && ~isempty(it.tooHeavy) && isSameKind(it.tooHeavy, block));
  end
end
