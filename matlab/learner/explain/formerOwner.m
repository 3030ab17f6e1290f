function name = formerOwner(demo, step)
% Returns the name of another moved object of a demonstration that began at the place of a step; '' if there is none.
  n = find(strcmp(demo.ids, step.name));
  name = '';
  for other = movedObjects(demo)
    if other ~= n && isSamePose(demo.start(other, :), demo.final(n, :))
      name = demo.ids{other};
      return
    end
  end
end
