function press = newPress(control, after, before, later, changed)
% Returns a press of a control, like a switch, that a demonstration shows.
%   control   its name in the demonstration, for messages
%   after     numbers of the steps that were done before it, 1xN
%   before    picture of the demonstration before it, HxWx3
%   later     and after it
%   changed   mask of the pixels that it changed, HxW logical
%   unchanged numbers of the regions that only other presses of the control changed, HxW; 0 elsewhere
%   tool      that was used, a step (see newStep) where it began and ended; [] for the press of a button
%   pose      of a tool: x y z of its center when it was used [units], and its yaw then [rad], 1x4
%   begin     x y z of its center where its straight way to there began, 1x3 [units]
%   at        x y of what a tool worked on, if that looks the same from all sides, 1x2 [units]; otherwise []
%   turns     of a drive, 1xN struct: fastener, its name; place, x y z of the center of the tool when they began [units];
%             number; isLoosening. [] for others
%   height    of the center of a tool that drives, at which it passed over everything [units]
%   grasp     of the last attempt of a drive
%   attempts  number of times that it was tried
%   done      whether it is done
  press = struct('control', control, 'after', after, 'before', before, 'later', later, 'changed', changed, ...
                 'unchanged', [], 'tool', [], 'pose', [], 'begin', [], 'at', [], 'turns', [], 'height', [], ...
                 'grasp', [], 'attempts', 0, 'done', false);
end
