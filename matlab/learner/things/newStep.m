function step = newStep(block, name)
% Returns a step of a task: a block (see newBlock) at its place in the finished building, and
%   name      of the object in the demonstration, for messages
%   on        numbers of the steps that it stands on; empty for an object on the table
%   displacement  by which it was dragged, 1x2 [units]; empty for an object that was carried. Color and
%             size of a dragged object are those of its handle.
%   stays     true for an object that the demonstration did not move
%   beginsThere  true for an object that began where it ends
%   after     numbers of steps that must be done before it, also if it does not stand on them
%   takesPlaceOf  name of the object that began at the place of this step; empty if there is none
%   start     its center at the start of the demonstration, 1x3 [units]; [] if unknown
%   startSize  as size, of an object that began on another face; [] for others
%   aside     where it was put before it came back, see asideOf; [] for others
%   tolerance  of its position [units]
%   beganOn   what it stood on at the start, where that tells it from others that look the same, see startSupport; [] if not
%   anchor    name of the object, or 'the table', relative to which its place was shown; '' if it may stand anywhere
% Its color is [] if the demonstrator specified that color does not matter.
  step = block;
  step.name = name;
  step.on = [];
  step.displacement = [];
  step.stays = false;
  step.beginsThere = false;
  step.after = [];
  step.takesPlaceOf = '';
  step.start = [];
  step.startSize = [];
  step.aside = [];
  step.tolerance = constants().blocks.position_tolerance;
  step.anchor = '';
  step.beganOn = [];
end
