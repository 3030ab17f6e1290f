function progress = newProgress(num_steps)
% What the brain remembers of the building.
%   step   the number of the step at hand; behind the last one when all is done
%   tries  how often its block has been carried so far
%   seen   where each step's block was when last seen: see findBlock; {} before
%   miss   by how much each block misses its goal: units, rad
  progress = struct('step', 1, 'tries', 0, 'seen', {cell(1, num_steps)}, 'miss', zeros(num_steps, 2));
end
