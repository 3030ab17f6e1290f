function actions = follow(arm, varargin)
% Returns the actions to follow motions, one after another.
  actions = cellfun(@(motion) struct('kind', 'follow', 'arm', arm, 'motion', motion), varargin, ...
                    'UniformOutput', false);
end
