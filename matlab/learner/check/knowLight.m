function state = knowLight(state, picture)
% Gives the pictures of controls and tools, and what is wanted, the colors that they have in the light of a picture. Things
% whose colors have changed in other ways remain unknown.
  if isempty(state.presses), return; end
  smallest = constants().perception.min_unknown_object_pixels;
  gains = gainsBetween(frequentColors(state.presses(1).before, smallest)', frequentColors(picture, smallest)');
  if all(gains == 1), return; end
  for k = 1:numel(state.presses)
    state.presses(k).before = brightened(state.presses(k).before, gains);
    state.presses(k).later = brightened(state.presses(k).later, gains);
    state.presses(k).tool = lit(state.presses(k).tool, gains);
  end
  state.steps = lit(state.steps, gains);
  state.unknownObjects = lit(state.unknownObjects, gains);
  state.containers = lit(state.containers, gains);
end

function things = lit(things, gains)
% Gives things, their knobs and their parts the colors in a light with some gains.
  for k = 1:numel(things)
    if ~isempty(things(k).color), things(k).color = brightened(things(k).color, gains); end
    if ~isempty(things(k).knob), things(k).knob = lit(things(k).knob, gains); end
    if ~isempty(things(k).parts), things(k).parts = lit(things(k).parts, gains); end
  end
end
