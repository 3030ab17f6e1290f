if sensor.simTime > 3  % before, the string sinks
  [work, motor, aux] = stepWork(work, sensor, motor, aux);
end
