function block = measureOtherTop(demo, n, lower, frames, pictures)
% Measures an object by its flat top; by the outline of its top if there is no such top, or if that may be only a part of it:
% where it is not round and nothing is near that could hide the rest. A block at its first place; a 1x0 struct array if no
% picture shows either.
%   lower, frames, pictures  as in measureObjects
  block = measureFlatTop(demo, n, lower);
  if ~isempty(block) && (isRound(block) || ~standsAlone(demo, n)), return; end
  outlined = measureOutlined(demo, n, frames, pictures);
  if ~isempty(outlined), block = outlined; end
end

function yes = standsAlone(demo, n)
% Returns true if an object began away from all others.
  away = demo.start([1:n - 1, n + 1:end], 1:2) - demo.start(n, 1:2);
  yes = all(hypot(away(:, 1), away(:, 2)) > constants().task_model.alone_distance);
end
