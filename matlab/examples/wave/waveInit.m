% Both arms begin stretched to the front, elbows a little bent.
period = 4;        % seconds for one wave
speed = 0.4;       % rad/s at the fastest
next_report = 0;   % when to print again, in seconds
aux.initJointAngles = [0 -0.5 0 1.0 0 0.5 0;
                       0 -0.5 0 1.0 0 0.5 0];
