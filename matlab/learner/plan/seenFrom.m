function [begin, last, yaw] = seenFrom(use, side, alignment)
% Returns the begin and the end of the straight way of a use in the scene, x y z each, and its yaw [rad], turned about what it
% works on by some angle [rad].
  turned = @(at) at(1:2);
  if ~isempty(use.at), turned = @(at) use.at + rotated(at(1:2) - use.at, side); end
  placed = @(at) [rotated(turned(at) - alignment.place, -alignment.angle), at(3)];
  begin = placed(use.begin);
  last = placed(use.pose(1:3));
  yaw = use.pose(4) + side - alignment.angle;
end
