function yes = hasShape(demo, n, shape)
% Returns true if object n of a demonstration is of a shape, like block, or composite for several, as the texts of a
% recording say.
  yes = false;
  for event = demo.events(strcmp({demo.events.word}, 'create'))
    if strcmp(event.fields{1}, demo.ids{n}), yes = any(strcmp(event.fields(2:min(3, end)), shape)); end
  end
end
