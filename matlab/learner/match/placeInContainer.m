function [steps, container, problem] = placeInContainer(steps, container, known, picture, eye)
% Moves steps together with their container to where it is detected, or, where it is covered from the start, to
% where it must be below its cover. If it is not visible, problem says so.
  problem = '';
  [found, rotation] = detectContainer(picture, eye, container);
  if isempty(found), [found, rotation] = belowCover(steps, container, known); end
  if isempty(found)
    problem = sprintf('the container %s is not visible', container.name);
    return
  end
  for k = 1:numel(steps)
    displacement = rotated(steps(k).position(1:2) - container.position(1:2), rotation);
    steps(k).position(1:2) = found.position(1:2) + displacement;
    steps(k).yaw = steps(k).yaw + rotation;
    % What fingers cannot put there is dropped, and lies anywhere inside.
    if isempty(graspYaws(steps(k), containerWalls(found)))
      steps(k).tolerance = constants().blocks.confined_tolerance;
    end
  end
  container = found;
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
