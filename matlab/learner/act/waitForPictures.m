function [action, ticks, status, image_seconds, sensor] = waitForPictures(action, sensor, aux)
% Waits until the arms rest, then for a picture; if it has noise, for so many that their mean has little,
% which takes the place of the last one, without that.
  c = constants().execution;
  ticks = 1;
  status = 'busy';
  image_seconds = 0;  % with the next step
  if action.time <= c.settle_s || ~isfield(sensor, 'rgbVision')
    ticks = max(ticksWithin(c.settle_s - action.time, aux) + 1, 1);
    return
  end
  if ~isfield(action, 'pictures')
    action.pictures = struct('sum', 0, 'count', 0, 'noise', noiseOf(sensor.rgbVision));
  end
  action.pictures.sum = action.pictures.sum + sensor.rgbVision;
  action.pictures.count = action.pictures.count + 1;
  seen = action.pictures;
  if seen.count < numPictures(seen.noise), return; end
  if seen.noise > 0, sensor.rgbVision = withoutNoise(seen.sum / seen.count, seen.noise, seen.count); end
  image_seconds = c.no_image_s;
  status = 'done';
end
