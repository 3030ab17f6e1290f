function [action, ticks, status, image_seconds, sensor] = waitForPictures(action, sensor, aux)
% Waits until the arms rest, then for a picture; if it has noise, for so many that their mean has little,
% which takes the place of the last one.
  c = constants().execution;
  ticks = 1;
  status = 'busy';
  image_seconds = 0;  % with the next step
  if action.time <= c.settle_s || ~isfield(sensor, 'rgbVision')
    ticks = max(ticksWithin(c.settle_s - action.time, aux) + 1, 1);
    return
  end
  if ~isfield(action, 'pictures')
    action.pictures = struct('sum', 0, 'count', 0, 'wanted', numPictures(sensor.rgbVision));
  end
  action.pictures.sum = action.pictures.sum + sensor.rgbVision;
  action.pictures.count = action.pictures.count + 1;
  if action.pictures.count < action.pictures.wanted, return; end
  if action.pictures.count > 1, sensor.rgbVision = action.pictures.sum / action.pictures.count; end
  image_seconds = c.no_image_s;
  status = 'done';
end
