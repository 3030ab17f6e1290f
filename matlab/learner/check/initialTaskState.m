function state = initialTaskState(steps, containers, presses, shown, choices)
% Returns the state of the learner at the beginning of a task.
%   steps      see newStep; once a site is chosen, at their places in this scene
%   containers  that some of them go into, see measureContainers; once a site is chosen, in this scene
%   hasSite    true once a site is chosen
%   known      beliefs: the blocks at the places where they were last seen; see newBlock
%   unknownObjects  appearances of blocks that belong to no step; their places are among known
%   unexplained  points, Nx2, as from unexplainedPoints
%   done       whether each step's block is in its place, 1xN logical
%   attempts   number of times that each step's block was carried there, 1xN
%   numTemporary  number of blocks that were put at a temporary place so far
%   placementErrors  of each block when last seen: [units, rad], Nx2
%   numBlocked  number of successive steps for which no plan was found
%   firstFailure  why the first of them failed
%   intention  a step that is not done yet, and for which something was done already: step, its number, and isLastResort,
%              whether no other step could be done either; [] if there is none
%   left       blocks at the places from which they were put aside
%   asides     for which step a block was put aside: step, its number, and place, the block there
%   grasp      of the current actions, see newGrasp; its block is the last of the known
%   failures   grasps that failed, not to be repeated
%   meant      as from meantBlocks, once a site is chosen
%   handLooks  places that were looked at by hands, or aside, Nx2 [units]
%   impossibleMoves  as from rememberImpossible, where everything is now; impossibleAmong: the blocks known then
%   moved      name of the last of the known, if it was moved and not seen since then; empty if not
%   notes      that were not told yet, see asNote
%   presses    of switches and buttons, and uses of tools, in the demonstrated order: see newPress; optional
%   shown      the eye of the demonstration, which shows them
%   unclear    what was not understood of it, in words, 1xN cell
%   choices    between several good ways, see choicesOf; optional
%   alignments  how the scene lies in the demonstration around each control, see align: control, angle, place
%   lastPicture, numLooks, numStill  seen before the scene was still, number of pictures until then, and of the last of
%              them in which nothing moved
%   unseenColors  of things in the demonstration, not yet seen here, Nx3; NaN: all
%   surface    what the eye sees now, see surfaceOf, if something has to be put aside; [] if not
%   claim      about the result, at the end: done, true if everything is built, and reason, one line; see
%              giveUp
  if nargin < 4
    presses = noPresses();
    shown = [];
  end
  if nargin < 5, choices = choicesOf(struct()); end
  n = numel(steps);
  state = struct('steps', steps, 'containers', {containers}, 'hasSite', false, 'known', noBlocks(), ...
                 'unknownObjects', noBlocks(), 'unexplained', zeros(0, 2), 'done', false(1, n), ...
                 'attempts', zeros(1, n), 'numTemporary', 0, 'placementErrors', NaN(n, 2), 'numBlocked', 0, ...
                 'firstFailure', '', 'intention', [], 'meant', NaN(n, 3), 'handLooks', zeros(0, 2), 'impossibleAmong', noBlocks(), ...
                 'impossibleMoves', struct('step', {}, 'place', {}, 'isToGoal', {}, 'turns', {}, 'room', {}, 'reason', {}), ...
                 'left', noBlocks(), 'asides', struct('step', {}, 'place', {}), 'grasp', [], ...
                 'failures', {struct('position', {}, 'arm', {}, 'yaw', {}, 'tooHeavy', {})}, 'moved', '', ...
                 'notes', asNote({}, {}), 'presses', presses, 'shown', shown, 'unclear', {{}}, 'choices', choices, ...
                 'alignments', struct('angle', {}, 'place', {}, 'control', {}), 'lastPicture', [], 'numLooks', 0, ...
                 'numStill', 0, 'claim', [], 'surface', [], 'unseenColors', NaN);
  state.unknownObjects = startSupportsOf(steps);
  % What has to be turned may lie on any of its faces.
  for step = steps(~cellfun(@isempty, {steps.startSize}))
    for sides = onEachFace(step.size)'
      if sameSize(sides', step.size), continue; end
      state.unknownObjects(end + 1) = newBlock(step.color, sides', [0, 0, sides(3) / 2], 0);
    end
  end
end
