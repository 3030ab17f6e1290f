function check_site()
% The building is where the demonstration moved nothing.
  eye = robotEye();
  brown = [0.5, 0.3, 0.2];
  bases = [asStep(block(brown, [4, 1, 1], 1, -2, 0, 0.1)), asStep(block(brown, [1, 1, 1], 1, 0, 0, 0))];
  [bases.stays] = deal(true);
  state = initialTaskState(bases, []);
  state.known = [block(brown, [4, 1, 1], -2, -2, 0, 0.1 - pi / 2), block(brown, [1, 1, 1], 0, -2, 0, 0), ...
                 block(brown, [4, 1, 1], 3, -2, 0, 0.3)];
  state = chooseSite(state, [], [], eye);
  errors = vertcat(state.steps.position) - vertcat(state.known(1:2).position);
  check(state.hasSite && max(abs(errors(:))) < 1e-9, ...
        'what stays determines the site');

  % Each of two plates, arranged differently here, has a step on it.
  plates = [asStep(block(brown, [2, 2, 0.2], -2, 1, 0, 0)), asStep(block([0, 0, 1], [2, 2, 0.2], 2, 1, 0, 0))];
  [plates.stays] = deal(true);
  known = [block(brown, [2, 2, 0.2], -3, -2, 0, 0), block([0, 0, 1], [2, 2, 0.2], 2, -3, 0, 0.3)];
  on_plates = [asStep(block(brown, [1, 1, 1], -2, 1, 0.2, 0)), asStep(block(brown, [1, 1, 1], 2, 1.2, 0.2, 0))];
  [on_plates.stays] = deal(true);  % no arm has to reach them
  known = [known, block(brown, [1, 1, 1], -3, -2, 0.2, 0), ...
           block(brown, [1, 1, 1], 2 - 0.2 * sin(0.3), -3 + 0.2 * cos(0.3), 0.2, 0.3)];
  moved = placeByWhatStays([plates, on_plates], known, [], eye);
  errors = vertcat(moved.position) - vertcat(known.position);
  check(max(abs(errors(:))) < 1e-9, 'each object that stays determines where the steps on it go');
end
