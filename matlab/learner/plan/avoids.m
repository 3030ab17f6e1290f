function yes = avoids(surroundings, arm, path, load)
% Returns true if an arm, from its fingers on, and its load pass over its surroundings (see surroundingsOf) on a path.
%   load  as from loadOf; omitted for none
  samples = samplesOf(path);
  tools = smileForward(arm.robot, arm.name, samples);
  % What an arm carries is more often in the way than the arm itself, and is tested faster: a few moments at once, of which the
  % first ones show most of what is in the way.
  if nargin > 3
    at_once = 8;
    for first = 1:at_once:rows(samples)
      some = first:min(first + at_once - 1, rows(samples));
      yes = isSkylineBelow(surroundings.ofLoad, loadAt(load, tools(:, :, some)));
      if ~yes, return; end
    end
  end
  yes = isSkylineBelow(surroundings.ofArm, handAndForearm(arm, samples, tools));
end
