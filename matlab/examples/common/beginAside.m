% Begins with the arms aside, so that the eye sees the table. Pictures come on request only.
robot = smileRobot(aux);
aside = asideAngles(robot);
for k = 1:numel(aux.arms), aux.arms(k).initJoints = aside(k, :); end
aux.channels = {'rgb', 'depth'};
aux.imageSeconds = 3600;
