% The arms begin aside, so that the eye sees the table.
addpath([aux.path '../common']);
robot = smileRobot(aux);
aside = [1.3 -1 -1.19 1.94 0.67 1.03 -0.5; -1.3 -1 1.19 1.94 -0.67 1.03 0.5];
aux.initJointAngles = aside;
aux.channels = {'rgb', 'depth'};
aux.imageSeconds = 3600;
work = newWork(look(@(sensor, aux) replaceFuse(robot, aside, sensor, aux)));
