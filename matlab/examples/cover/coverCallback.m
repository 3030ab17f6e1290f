[work, motor, aux] = stepWork(work, sensor, motor, aux);
