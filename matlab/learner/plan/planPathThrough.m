function path = planPathThrough(arm, poses, others, q, placed, taken)
% Plans the paths of an arm to the first of some tool poses, along straight lines through the others, and
% to its parking pose: a 1xN cell; {} if there is none.
%   poses   1xN cell of 4x4 [units]
%   others  obstacles for the arm, as blocks, where the tool is lower than the highest pose
%   q       its joint angles, 1xn [rad]
%   placed  what it leaves there, as blocks: obstacles on the way to its parking pose; omitted for none
%   taken   what it takes there, as blocks: obstacles on the way from where it is; omitted for none
  if nargin < 5, placed = noBlocks(); end
  if nargin < 6, taken = noBlocks(); end
  height = max(cellfun(@(pose) pose(3, 4), poses));
  possible = {};
  for start = arm.starts'
    found = solvePoses(arm, poses, start');
    if isempty(found), continue; end
    path = {moveJoints(arm, [q; found(1, :)])};
    for pose = poses(2:end)
      path{end + 1} = moveLine(arm, path{end}, pose{1});
      if isempty(path{end}), break; end
    end
    if isempty(path{end}), continue; end
    low = find(cellfun(@(pose) pose(3, 4) < height, poses));
    if ~all(arrayfun(@(i) isArmClear(arm, path{i}.positions(end, :), others), low)), continue; end
    % From and to where it waits, only this tells whether it passes over all.
    if ~all(cellfun(@(move) isPathValid(arm, move), path)) || ~isPathOver(arm, path{1}, [others, taken]), continue; end
    home = pathHome(arm, path{end}, [others, placed], 0);
    if ~isempty(home)
      path{end + 1} = home;
      return
    end
    possible{end + 1} = path;
  end
  for it = possible
    path = it{1};
    for rise = constants().motion_planning.rises'
      home = pathHome(arm, path{end}, [others, placed], rise);
      if ~isempty(home)
        path{end + 1} = home;
        return
      end
    end
  end
  path = {};
end

function path = pathHome(arm, before, obstacles, rise)
% Returns a path of an arm from the end of another one to its parking pose, raised first by a height [units], over obstacles;
% [] if there is none.
  waypoints = before.positions(end, :);
  path = [];
  if rise > 0
    here = smileForward(arm.robot, arm.name, waypoints);
    raised = moveLine(arm, before, atHeight(here, here(3, 4) + rise));
    if isempty(raised), return; end
    waypoints = [waypoints; raised.positions(end, :)];
  end
  path = moveJoints(arm, [waypoints; arm.parked]);
  if ~isPathValid(arm, path) || ~isPathOver(arm, path, obstacles), path = []; end
end
