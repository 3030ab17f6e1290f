function [steps, found, problem] = placeInContainers(steps, containers, known, picture, eye)
% Moves steps together with the container that each of them is in, or with the first one, to where this is detected, or, where it is
% covered from the start, to where it must be below its cover. If one is not visible, problem says so.
%   found  the containers there
  problem = '';
  found = [];
  owner = arrayfun(@(it) numberOf(it, containers), steps);
  for n = 1:numel(containers)
    [there, rotation] = detectContainer(picture, eye, containers(n), found);
    if isempty(there), [there, rotation] = belowCover(steps(owner == n), containers(n), known); end
    if isempty(there)
      problem = sprintf('the container %s is not visible', containers(n).name);
      return
    end
    found = [found, there];
    for k = find(owner == n), steps(k) = movedWith(steps(k), containers(n), there, rotation); end
  end
end

function n = numberOf(step, containers)
% Returns the number of the container that a step is in; 1 if it is in none.
  n = 1;
  for k = numel(containers):-1:1
    if isInside(containers(k), step.position), n = k; end
  end
end

function step = movedWith(step, container, there, rotation)
% Returns a step where it is relative to a container, which was found there, rotated [rad].
  displacement = rotated(step.position(1:2) - container.position(1:2), rotation);
  step.position(1:2) = there.position(1:2) + displacement;
  step.yaw = step.yaw + rotation;
  % What fingers cannot put there is dropped, and lies anywhere inside.
  if isempty(graspYaws(step, containerWalls(there))), step.tolerance = constants().blocks.confined_tolerance; end
end

function [container, rotation] = belowCover(steps, container, known)
% Returns where a container must be below a known block that is in its final place from the start, like a lid,
% and the rotation from the demonstration [rad]; [] and 0 if there is none.
  for step = steps([steps.beginsThere])
    for block = known(arrayfun(@(it) isSameKind(it, step), known))
      rotation = yawDifference(step, block.yaw);
      container = turnedAbout(step, container, rotation, block);
      return
    end
  end
  container = [];
  rotation = 0;
end
