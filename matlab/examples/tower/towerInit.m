% What the demonstration shows is read at once; of this scene nothing is known before the first look.
if ~isfield(aux, 'demonstration')
  error('this brain needs a demonstration: smile imitate DEMO SCENE --brain matlab/examples/tower');
end
steps = understandTower(readDemonstration(aux.demonstration));
fprintf('shown: a tower of%s\n', sprintf(' %s', steps.color));

camera = struct('intrinsics', aux.cameraIntrinsics, 'pose', aux.cameraPose);
shoulders = [];                         % where the arms' mounts are; found at the first callback
progress = newProgress(numel(steps));   % what is known about this scene and done so far
actions = {struct('kind', 'look')};     % what to do next, in this order
is_recovering = false;                  % true after an action went wrong

% The arms begin where they do not stand in the picture.
aux.initJointAngles = [parkedAngles(1); parkedAngles(2)];
