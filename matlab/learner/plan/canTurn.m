function yes = canTurn(arms, block, held, others)
% Returns true if an arm can turn a block where it is: see planTurn.
  like = block;
  like.size = turnedSize(block.size, held);
  like.position(3) = block.position(3) + (like.size(3) - block.size(3)) / 2;
  height = turnHeight(block, others);
  margin = constants().motion_planning.tilted_limit_rad;
  yes = true;
  for arm = arms(arrayfun(@(arm) canHold(arm, block.size(held)), arms))
    for grasp = tiltedGrasps(arm, block, held, others, margin)
      for yaw = (0:3) * pi / 4
        like.yaw = yaw;
        for ends = endPoses(grasp{1}, like, height)
          if ~isempty(solvePoses(arm, ends', grasp{1}.q(1, :), margin)), return; end
        end
      end
    end
  end
  yes = false;
end
