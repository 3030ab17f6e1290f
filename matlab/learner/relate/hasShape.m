function yes = isComposite(demo, n)
% Returns true if object n of a demonstration is of several shapes, as the texts of a recording say.
  yes = false;
  for event = demo.events(strcmp({demo.events.word}, 'create'))
    if strcmp(event.fields{1}, demo.ids{n}), yes = any(strcmp(event.fields(2:min(3, end)), 'composite')); end
  end
end
