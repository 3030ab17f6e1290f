function [container, turn] = findContainer(picture, eye, container)
% A container of the demonstration where it stands in a picture, and how far it is turned from there
% [rad]; [] if it is not seen.
  for face = findOutlines(picture, eye, container.color, container.size(3))
    if ~sameSize(face.sides, container.size(1:2)), continue; end
    turn = turnBetween(container, face.yaw);
    container.position(1:2) = face.center;
    container.yaw = container.yaw + turn;
    return
  end
  container = [];
  turn = 0;
end
