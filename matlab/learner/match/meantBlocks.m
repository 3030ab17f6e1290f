function meant = meantBlocks(steps, known)
% Returns which of the known blocks is meant by each of N steps whose object began on something else than others like it:
% their positions, Nx3; NaN for other steps, and for those whose block is not seen there.
  meant = NaN(numel(steps), 3);
  misfits = Inf(numel(steps), numel(known));
  for k = find(~cellfun(@isempty, {steps.beganOn}))
    for i = find(arrayfun(@(it) isSameKind(it, steps(k)), known))
      misfits(k, i) = misfitOf(known(i), steps(k).beganOn, known);
    end
  end
  while any(isfinite(misfits(:)))
    % The first of equal ones in the order of steps, then of blocks.
    [~, best] = min(reshape(misfits', [], 1));
    [i, k] = ind2sub(size(misfits'), best);
    meant(k, :) = known(i).position;
    misfits(k, :) = Inf;
    misfits(:, i) = Inf;
  end
end

function misfit = misfitOf(block, support, known)
% Returns how far what a block stands on is from where the support of a step (see startSupport) was, among all that look
% like it [units]; Inf if it stands on something else.
  misfit = Inf;
  if isempty(support.like)
    if block.position(3) - block.size(3) / 2 < constants().perception.on_table, misfit = 0; end
    return
  end
  alike = known(arrayfun(@(it) isSameKind(it, support.like), known));
  if isempty(alike), return; end
  positions = vertcat(alike.position);
  for it = alike
    if isequal(it.position, block.position) || ~standsOn(block, it), continue; end
    misfit = min(misfit, norm(it.position(1:2) - mean(positions(:, 1:2), 1) - support.away));
  end
end
