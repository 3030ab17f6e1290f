function move = newMove(block, goal, turns, room)
% Returns a move that may come next.
%   block  number of a known block
%   goal   the step to which it goes; [] or omitted for a temporary placement
%   turns  how it has to be turned there, and again after that, as from turnsBetween; [] or omitted for not at all
%   room   another block, at the place that this move makes free for it; [] or omitted for none
  if nargin < 2, goal = []; end
  if nargin < 3, turns = []; end
  if nargin < 4, room = []; end
  move = struct('block', block, 'goal', {goal}, 'turns', turns, 'room', {room});
end
