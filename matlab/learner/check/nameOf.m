function name = nameOf(block, steps)
% Returns a name for a block that has none: that of the first step of its kind.
  name = 'an unknown object';
  for step = steps
    if isSameKind(block, step)
      name = ['one like ', step.name];
      return
    end
  end
end
