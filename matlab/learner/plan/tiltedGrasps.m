function grasps = tiltedGrasps(arm, block, held, others, margin)
% Returns the ways to hold a block for a turn that an arm reaches, with a margin from the limits of its joints [rad]: a 1xN
% cell of structs, see tiltedGrasp.
%   held  the side by which it is held, as in turnedSize
  grasps = {};
  height = turnHeight(block, others);
  for sign = [1, -1]
    for across = [1, -1]
      grasp = tiltedGrasp(arm, block, held, sign, across, height, margin);
      for first = arm.starts'
        grasp.q = solvePoses(arm, {grasp.overStart, grasp.start}, first', margin);
        if ~isempty(grasp.q) && isHandClear(arm, grasp.q, others, block)
          grasps{end + 1} = grasp;
          break
        end
      end
    end
  end
end
