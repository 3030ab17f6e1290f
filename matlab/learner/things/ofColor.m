function yes = ofColor(things, color)
% Returns which of some things have exactly a color, 1xN logical.
  yes = cellfun(@(it) isequal(it, color), {things.color});
end
