function block = newBlock(color, sides, position, yaw, form)
% Returns a block as the learner sees it.
%   color     1x3, red green blue, 0 to 1
%   size      its longer side, the shorter one, and its height [units]
%   position  of its center, 1x3 [units]
%   yaw       of its longer side [rad]
%   form      'block', 'disc' or 'ball'; the sides of the last two are their diameter
%   hasKnob   true if it is held by a part on its top,
%   knob      this one, a block in the frame of the object: its position is that of its middle from the
%             object's, turned back by the object's yaw; [] while it is unknown
%   otherKnobs  or one of these, where that is out of reach, a struct array
%   parts     of a thing of several colors, blocks in its frame: see measureParts
%   outline  of a top of another shape than a rectangle or a disc, see outlineOf; [] for others
%   depth     how far below its top the fingers may reach [units]
  if nargin < 5, form = 'block'; end
  block = struct('color', color, 'size', sides, 'position', position, 'yaw', yaw, 'form', form, ...
                 'hasKnob', false, 'knob', [], 'otherKnobs', [], 'parts', [], 'outline', [], 'depth', Inf);
end
