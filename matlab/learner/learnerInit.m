% Init: infers the task from the demonstration. This scene is unknown before the first picture.
if ~isfield(aux, 'demonstration')
  error('this brain needs a demonstration: smile imitate DEMO SCENE --brain matlab/learner');
end
state = [];
try
  [demo, steps, containers, presses, aux.notes] = understand(aux);
catch problem
  if ~strcmp(problem.identifier, 'learner:notUnderstood'), rethrow(problem); end
  aux = endWith(struct('done', false, 'reason', problem.message), 0, aux);
  return
end

arms = armsOf(aux);
hands = armsFor(steps, arms);
eye = eyeOfRobot(aux);
state = initialTaskState(steps, containers, presses, demo.eye, choicesOf(aux));  % beliefs about this scene, and progress
state.unclear = demo.unclear;
actions = {struct('kind', 'observe')};  % the next actions, in this order
num_retreats = 0;                       % number of successive retreats after failed actions

aux.channels = {'rgb', 'depth'};
aux.cameras = setdiff({hands.camera}, {''});

% The arms start outside the picture.
for k = 1:numel(arms), aux.arms(k).initJoints = arms(k).parked; end
joints = jointEstimates(arrayfun(@(arm) arm.initJoints(:), aux.arms, 'UniformOutput', false));
