function way = wayOf(choices, move)
% Returns how a block is held and carried in a move: the seed of the order in which grasps are tried, [] for that in which they
% are found; and by how much higher than necessary it is carried, the best first [units].
%   choices  see choicesOf
%   move     number of the moves before it
  way = struct('seed', [], 'rises', 0);
  if ~isempty(choices.grasp), way.seed = [choices.grasp; move]; end
  if ~isempty(choices.path)
    rand('twister', [choices.path; move]);
    way.rises = [rand * constants().motion_planning.max_rise, 0];
  end
end
