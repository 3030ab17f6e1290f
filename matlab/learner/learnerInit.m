% Init: infers the task from the demonstration. This scene is unknown before the first picture.
if ~isfield(aux, 'demonstration')
  error('this brain needs a demonstration: smile imitate DEMO SCENE --brain matlab/learner');
end
if exist(fullfile(aux.demonstration, '0.txt'), 'file')
  demo = readDemonstration(aux.demonstration);
else  % a recording without texts: from its pictures alone
  demo = watchDemonstration(aux.demonstration);
end
needs = needsOf(aux, demo);
[steps, container, appearances] = inferTask(demo, aux.attention, needs);
[keyframes, goal] = explain(demo, appearances, container);
unclear = {};
if isfield(demo, 'unclear'), unclear = demo.unclear; end
aux.notes = strcat({'understood: '}, strtrim(printPage(keyframes, goal, unclear)));
presses = inferDevices(demo, steps, appearances, needs);
printSteps(steps);
printPresses(presses, steps);

arms = armsOf(aux);
hands = armsFor(steps, arms);
eye = eyeOfRobot(aux);
state = initialTaskState(steps, container, presses, demo.eye, choicesOf(aux));  % beliefs about this scene, and progress
state.unclear = unclear;
actions = {struct('kind', 'observe')};  % the next actions, in this order
num_retreats = 0;                       % number of successive retreats after failed actions

aux.channels = {'rgb', 'depth'};
aux.cameras = setdiff({hands.camera}, {''});

% The arms start outside the picture.
for k = 1:numel(arms), aux.arms(k).initJoints = arms(k).parked; end
joints = jointEstimates(arrayfun(@(arm) arm.initJoints(:), aux.arms, 'UniformOutput', false));
