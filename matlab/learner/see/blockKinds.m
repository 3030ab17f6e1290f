function kinds = blockKinds(like, color)
% Returns the kinds of blocks among those of a color, 1x3: a struct array with color, size, form, outline and knobs.
%   like  blocks or steps
  kinds = struct('color', {}, 'size', {}, 'form', {}, 'parts', {}, 'outline', {}, 'knob', {}, ...
                 'otherKnobs', {});
  for it = like
    if ~sameColor(it.color, color) || any(arrayfun(@(kind) sameForm(kind, it), kinds)), continue; end
    kinds(end + 1) = struct('color', color, 'size', it.size, 'form', it.form, 'parts', [], 'outline', it.outline, ...
                            'knob', it.knob, 'otherKnobs', it.otherKnobs);
  end
end
