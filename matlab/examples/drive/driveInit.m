addpath([aux.path '../common']);
beginAside;
work = newWork(look(@(sensor, aux) replaceDrive(robot, aside, sensor, aux)));
