function [actions, progress] = decide(steps, progress, image, camera, shoulders)
% Looks where the blocks are and says what to do next; {} when the tower stands or nothing helps.
  actions = {};
  is_here = false(1, numel(steps));
  for k = 1:numel(steps)
    block = findBlock(image, camera, steps(k).color);
    is_here(k) = ~isempty(block);
    if is_here(k), progress.seen{k} = block; end
  end

  while progress.step <= numel(steps)
    k = progress.step;
    if ~is_here(k)
      fprintf('the %s block cannot be seen\n', steps(k).color);
      return
    end
    block = progress.seen{k};
    goal = goalOf(k, steps, progress.seen, shoulders);
    progress.miss(k, :) = [norm(block.position - goal.position), ...
                           abs(quarterTurn(block.yaw - goal.yaw))];
    if progress.miss(k, 1) > 0.08 || progress.miss(k, 2) > 0.05
      if progress.tries < 3
        progress.tries = progress.tries + 1;
        actions = carry(block, goal, progress.seen, shoulders);
        if isempty(actions), fprintf('no arm reaches the %s block\n', steps(k).color); end
      end
      return
    end
    progress.step = k + 1;
    progress.tries = 0;
  end
end
