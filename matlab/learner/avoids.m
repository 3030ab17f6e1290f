function yes = avoids(surroundings, arm, path, load)
% Returns true if an arm, from its fingers on, and its load pass over its surroundings (see surroundingsOf) on a path.
%   load  as from loadOf; omitted for none
  yes = true;
  for q = samplesOf(path)'
    tool = smileForward(arm.robot, arm.name, q');
    if nargin > 3, yes = isSkylineBelow(surroundings.ofLoad, load * tool(1:3, 1:3)' + tool(1:3, 4)'); end
    yes = yes && isSkylineBelow(surroundings.ofArm, handAndForearm(arm, q', tool));
    if ~yes, return; end
  end
end
