function hands = pushingHands(arm, block, way, others)
% Returns how the hand of an arm can push a block that is on a way (see pushWays) to its goal, with both fingers: a 1xN struct
% array.
%   others  obstacles, as blocks
%   hands   across   direction from finger to finger [rad]
%           opening  between them [units]
%           poses    of the tool, 1x3 cell of 4x4: behind the block, at the end of the way, and back from it
  c = constants().motion_planning;
  fingers = diff(smileFingerBounds(arm.robot, arm.name, 0));
  % So far apart that the block does not turn, but not beyond its sides, where others may touch it.
  opening = min(max(way.across - fingers(2) - c.push_margin, 0), arm.opening);
  away = [way.away, 0];
  up = [0, 0, block.size(3) / 2 - gripDepth(arm, block.size(3))];
  last = way.last.position + away * (way.along + fingers(1)) / 2;
  middles = {block.position + away * ((way.along + fingers(1)) / 2 + c.push_margin), last, last + c.push_margin * away};
  % The fingers need room as if they held something as wide as they are open, with its sides toward the block.
  held = block;
  held.size = [way.across, opening - c.opening_margin, block.size(3)];
  held.yaw = atan2(away(2), away(1));
  hands = struct('across', {}, 'opening', {}, 'poses', {});
  yaws = yawsAt(held, middles{1}, others);
  for across = yaws(ismember(yaws, yawsAt(held, middles{2}, others)))
    poses = cellfun(@(it) toolPose(arm, it + up, across, opening), middles, 'UniformOutput', false);
    hands(end + 1) = struct('across', across, 'opening', opening, 'poses', {poses});
  end
end

function yaws = yawsAt(held, position, others)
% Returns the yaws of fingers that would hold something at a position.
  held.position = position;
  yaws = graspYaws(held, others);
end
