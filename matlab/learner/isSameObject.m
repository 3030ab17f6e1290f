function yes = isSameObject(object, block, near)
% Returns true if a block may be a tracked object: it looks like it, and is less than `near` from its place [units].
  yes = sameColor(object.color, block.color) && sameSize(object.size, block.size) && ...
        norm(object.position - block.position) < near;
end
