function world = worldAfter(action, world, ids)
% Updates what hands hold, and the facts about controls and joints, after an action of a demonstration.
%   world.held    number of the object in each hand, a struct
%   world.names   facts without their last word, 1xN cell
%   world.values  their last words
  words = action.fields;
  switch action.word
    case 'grasp'
      world.held.(words{1}) = find(strcmp(ids, words{2}));
    case {'release', 'destroy'}
      if isfield(world.held, words{1}), world.held = rmfield(world.held, words{1}); end
    case 'delete'
      set(['gone ', words{1}], '');
    case 'initializeControl'
      set(['state ', words{1}], words{end});
    case 'changeControlState'
      set(['state ', words{1}], words{2});
    case 'use'
      if strcmp(words{3}, 'cut'), set(['cut ', strtok(words{4})], words{2}); end
    case 'fasten'
      set(['fastened ', words{3}, ' ', words{5}], '');
    case 'loosen'
      if str2double(words{6}) == 0
        is_loose = strcmp(world.names, ['fastened ', words{3}, ' ', words{5}]);
        world.names(is_loose) = [];
        world.values(is_loose) = [];
      end
  end

  function set(name, value)
    k = find(strcmp(world.names, name));
    if isempty(k), k = numel(world.names) + 1; end
    world.names{k} = name;
    world.values{k} = value;
  end
end
