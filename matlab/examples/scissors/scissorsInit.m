addpath([aux.path '../common']);
beginAside;
work = newWork(look(@(sensor, aux) cutString(3, robot, aside, sensor, aux)));
