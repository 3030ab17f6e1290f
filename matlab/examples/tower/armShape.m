function shape = armShape(arm)
% Baxter's arm in units of 0.1 m; arm 1 is the left one, 2 the right one.
%
% Seen from the side, with E0 = W0 = 0:
%
%      S1 ---upper---.            each of the two long links ends with a short step
%      |             | elbow      downwards (elbow, wrist); then the hand goes on to the
%     S0           E1 ---fore--.  tool, the point between the fingers
%                             W1 ---hand--- tool
  shape.upper = 3.6442;
  shape.elbow = 0.69;
  shape.fore = 3.7429;
  shape.wrist = 0.10;
  shape.hand = 2.29525 + 0.818;  % to the flange, and from there to the tool
  shape.out = 0.69;              % from the axis of S0 forward to that of S1
  shape.up = 2.7035;             % from the arm's mount up to S1
  headings = [3, 1] * pi / 4;    % where S0 = 0 points: left arm and right arm, seen from above,
  shape.heading = headings(arm); % counted from the table's x axis
end
