function [container, rotation] = detectContainer(picture, eye, container, others)
% Detects a container of the demonstration in a picture. Returns it at its new place and its rotation
% from the old one [rad]; [] and 0 if it is not visible. others: containers that are known already, [] for none; optional
  if nargin < 4, others = []; end
  for face = detectRims(picture, eye, container.color, container.size(3))
    if ~sameSize(face.sides, container.size(1:2)) || ~isempty(containerAt(others, face.center)), continue; end
    rotation = yawDifference(container, face.yaw);
    container.position(1:2) = face.center;
    container.yaw = container.yaw + rotation;
    return
  end
  container = [];
  rotation = 0;
end
