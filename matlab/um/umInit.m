% What the demonstration shows is understood at once; of this scene nothing is known before the first
% look.
if ~isfield(aux, 'demonstration')
  error('this brain needs a demonstration: smile imitate DEMO SCENE --brain matlab/um');
end
if exist(fullfile(aux.demonstration, '0.txt'), 'file')
  demo = readDemonstration(aux.demonstration);
else  % without words it is understood from its pictures
  demo = watchDemonstration(aux.demonstration);
end
[steps, container] = understand(demo, aux.attention);
printSteps(steps);

robot = smileRobot(aux);
eye = struct('intrinsics', aux.cameraIntrinsics, 'pose', aux.cameraPose);
building = startBuilding(steps, container);  % what is known about this scene, and what was done so far
actions = {struct('kind', 'look')};   % what to do next, in this order
is_recovering = false;                % true after an action went wrong

aux.imageSeconds = constants().act.image_s;
% The arms begin where they do not stand in the picture.
aux.initJointAngles = [parkedAngles(1); parkedAngles(2)];
