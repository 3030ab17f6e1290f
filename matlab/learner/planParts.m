function path = planParts(arm, parts, is_line, q, isClear)
% Plans the paths of an arm along straight lines through the tool poses of each part, from part to part on a straight line
% or any way, and to its parking pose: a 1xN cell; {} if there is none.
%   parts  cells of 4x4 [units]
%   q      its joint angles, 1xn [rad]
%   isClear  function of these paths: whether nothing is in the way
  for first = arm.starts'
    path = pathThroughParts(arm, parts, is_line, q, first');
    if isempty(path), continue; end
    path{end + 1} = moveJoints(arm, [path{end}.positions(end, :); arm.parked]);
    if all(cellfun(@(move) isPathValid(arm, move), path)) && isClear(path), return; end
  end
  path = {};
end

function path = pathThroughParts(arm, parts, is_line, q, first)
% Returns the paths without the last one, joint angles searched from some first ones; {} if there are none.
  path = {};
  for part = parts
    poses = part{1};
    if isempty(path) || ~is_line
      here = first;
      if ~isempty(path)
        here = path{end}.positions(end, :);
        q = here;
      end
      above = solvePoseSequence(arm, poses, here);
      if isempty(above)
        path = {};
        return
      end
      path{end + 1} = moveJoints(arm, [q; above]);
      poses(1) = [];
    end
    for pose = poses
      path{end + 1} = moveLine(arm, path{end}, pose{1});
      if isempty(path{end})
        path = {};
        return
      end
    end
  end
end
