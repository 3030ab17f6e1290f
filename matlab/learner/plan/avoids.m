function yes = avoids(surroundings, arm, path, load)
% Returns true if an arm, from its fingers on, and its load pass over its surroundings (see surroundingsOf) on a path.
%   load  as from loadOf; omitted for none
  samples = samplesOf(path);
  tools = cell(1, rows(samples));
  % What an arm carries is more often in the way than the arm itself, and is tested faster.
  for k = 1:numel(tools)
    tools{k} = smileForward(arm.robot, arm.name, samples(k, :));
    yes = nargin < 4 || isSkylineBelow(surroundings.ofLoad, load * tools{k}(1:3, 1:3)' + tools{k}(1:3, 4)');
    if ~yes, return; end
  end
  yes = isSkylineBelow(surroundings.ofArm, handAndForearm(arm, samples, tools));
end
