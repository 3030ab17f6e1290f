function check_noise()
  told = [zeros(2, 20), repmat([0.5; -0.5], 1, 60), zeros(2, 20)];
  truths = cumsum([[0; 0], told(:, 1:end - 1)], 2) / 60;
  pushed = truths + [zeros(2, 90), repmat(0.1, 2, 10)];
  check(isequal(estimatesWhile(pushed, told, 0), pushed), 'sensors without noise are believed');
  errors = abs(estimatesWhile(truths, told, 0.01) - truths);
  check(max(errors(:)) < 0.004, 'noisy joints are where the motors brought them');
  told = [zeros(2, 20), repmat([0.2; 0], 1, 120)];
  blocked = estimatesWhile(zeros(2, 140), told, 0.01);
  check(max(abs(blocked(:))) < 0.1, 'joints stop at an obstacle whatever the motors are told');

  picture = pictureOf(block([1, 0, 0], [4, 1, 1], 0, -2, 0, 0));
  check(numPictures(noiseOf(picture)) == 1, 'one picture without noise is enough');
  count = numPictures(noiseOf(picture + 0.02 * randn(size(picture))));
  check(abs(count - 16) <= 1, 'noisy pictures are taken repeatedly');

  [picture, heights] = pictureOf([block([1, 0, 0], [4, 1, 1], 0, -2, 0, 0), block([0, 1, 0], [1, 1, 1], 3, -2, 0, 0.3)]);
  is_table = all(abs(picture - reshape([0.6, 0.5, 0.4], 1, 1, 3)) < 0.001, 3);
  picture(repmat(is_table, 1, 1, 3)) = 1;
  picture(1:100, :, :) = 0;
  picture = round(255 * picture) / 255;
  randn('seed', 1);
  total = 0;
  for k = 1:36
    seen = round(min(max(255 * picture + 7.5 * randn(size(picture)), 0), 255)) / 255;
    if k == 1, noise = noiseOf(seen); end
    total = total + seen;
  end
  check(abs(noise - 7.5 / 255) < 0.004, 'noise is measured where it is not cut off');
  found = withoutNoise(total / 36, noise, 36);
  wrong = mean(max(abs(found - picture), [], 3)(:) > 1.5 / 255);
  check(wrong < 0.001, 'noise leaves flat colors, also where it is cut off');
  check(numel(detectUnknownObjects(found, robotEye(), noBlocks(), heights)) == 2, 'unknown objects are found in noise');
end

function estimates = estimatesWhile(truths, told, noise)
% Returns the estimates of one arm of two joints that begins at [0; 0], 2xN.
  randn('seed', 1);
  joints = jointEstimates({[0; 0]});
  estimates = zeros(size(truths));
  for k = 1:size(truths, 2)
    sensor.timeElapsed = 1 / 60;
    sensor.arms = struct('joints', truths(:, k) + noise * randn(2, 1));
    [joints, sensor] = correctJoints(joints, sensor, 1 / 60);
    joints.told = {told(:, k)};
    estimates(:, k) = sensor.arms.joints;
  end
end
