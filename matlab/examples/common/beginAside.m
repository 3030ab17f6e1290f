% Begins with the arms of Baxter aside, so that the eye sees the table. Pictures come on request only.
robot = smileRobot(aux);
aside = [1.3 -1 -1.19 1.94 0.67 1.03 -0.5; -1.3 -1 1.19 1.94 -0.67 1.03 0.5];
aux.initJointAngles = aside;
aux.channels = {'rgb', 'depth'};
aux.imageSeconds = 3600;
