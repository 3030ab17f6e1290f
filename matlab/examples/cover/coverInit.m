addpath([aux.path '../common']);
beginAside;
work = newWork(look(@(sensor, aux) replaceFuse(robot, aside, sensor, aux)));
