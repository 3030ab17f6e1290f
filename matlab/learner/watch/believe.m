function objects = believe(objects)
% Returns to the doubted places of tracked objects (see newTracker) for which a picture showed no others.
  for n = find(~cellfun(@isempty, {objects.doubted}))
    if isempty(objects(n).block)
      objects(n).placed(end + 1) = objects(n).doubted;
      objects(n).block = objects(n).doubted.block;
    end
    objects(n).doubted = [];
  end
end
