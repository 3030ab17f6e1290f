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
  check(numPictures(picture) == 1, 'one picture without noise is enough');
  count = numPictures(picture + 0.02 * randn(size(picture)));
  check(abs(count - 16) <= 1, 'noisy pictures are taken repeatedly');
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
