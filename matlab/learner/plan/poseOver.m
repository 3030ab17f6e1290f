function pose = poseOver(hand, place, height)
% Returns the pose of an arm's tool, 4x4, with the center of what a hand (see drivingHand) holds over a place at a height.
  pose = toolPose(hand.arm, [place(1:2), height + hand.grip], 0, hand.width);
end
