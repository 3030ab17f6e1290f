function posture = highPosture(place, yaw, highest, shoulder, arm)
% Above a place, so high that a held block passes over all that is `highest` units high; [] if the arm
% does not get there.
  posture = toolPosture([place(1:2), highest + 0.8 + 0.1], yaw, shoulder, arm);
  % Close to the robot this folds the arm too much; then a little farther out.
  for i = 1:6
    if ~isempty(anglesFor(posture, arm)), return; end
    posture(2) = posture(2) + 0.05;
  end
  posture = [];
end
