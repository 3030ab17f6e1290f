% The arms begin aside, so that the eye sees the table.
robot = smileRobot(aux);
aside = [1.3 -1 -1.19 1.94 0.67 1.03 -0.5; -1.3 -1 1.19 1.94 -0.67 1.03 0.5];
aux.initJointAngles = aside;
aux.channels = {'rgb', 'depth'};
aux.imageSeconds = 3600;

actions = {};        % that are left
began = [];          % of the present action [s]
gain = 4;            % of the error of a joint [1/s]
settled = 0.002;     % error of a joint at the end of a motion [rad]
