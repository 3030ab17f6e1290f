function actions = follow(arm, motions)
% Returns the actions of an arm that follows motions, one after another.
  actions = cellfun(@(motion) struct('kind', 'follow', 'arm', arm, 'motion', motion), motions, ...
                    'UniformOutput', false);
end
