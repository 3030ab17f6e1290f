function properties = attended(attention, name)
% Returns the properties of an object that matter, 1xN cell, if the demonstrator specified some; otherwise {}.
%   attention  as in aux
  properties = {};
  for it = attention(:)'
    if strcmp(it.object, name) && ~isempty(it.properties), properties = it.properties; end
  end
end
