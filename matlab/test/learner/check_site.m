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
  check_anchor(eye);
  check_carried();
end

function check_carried()
% No robot is here: what is on something, or to the right, is within reach.
  eval('function yes = isReachable(~, step), yes = step.position(3) > 1 || step.position(1) > 0; end');
  eval('function arms = nearestFirst(varargin), arms = 1; end');
  remove = onCleanup(@() clear('-f', 'isReachable', 'nearestFirst'));
  brown = [0.5, 0.3, 0.2];
  sites = {};
  for x = [-9, 3], sites{end + 1} = [asStep(block(brown, [1, 1, 1], x, -2, 0, 0)), asStep(block(brown, [1, 1, 1], x, -2, 1, 0))]; end
  for k = 1:2, sites{k}(1).stays = true; end
  check(firstWithinReach([1, 1], sites, [])(1).position(1) == -9, 'no arm has to reach what stays');
  check(firstWithinReach([1, 1], sites, [], true)(1).position(1) == 3, 'but where all is carried to a site');
end

function check_anchor(eye)
% A block was put beside a wall, or, in a scene of its own, elsewhere on the table.
  blue = asStep(block([0, 0, 1], [1, 1, 1], 2.8, -2, 0, 0));
  wall = asStep(block([0.5, 0.3, 0.2], [4, 1, 1], 0, -2, 0, 0));
  [blue.name, wall.name] = deal('Blue', 'Wall');
  wall.stays = true;
  alone = struct('ids', {{'Blue'}}, 'start', [4, -4, 0.5, 0, 0, 30], 'final', [2.8, -2, 0.5, 0, 0, 0]);
  steps = withAnchor(alone, blue, blue([]));
  check(numel(steps) == 1 && strcmp(steps.anchor, 'the table'), 'without another object its place on the table counts');
  demo = alone;
  demo.ids = {'Blue', 'Wall'};
  [demo.start, demo.final] = deal([demo.start; 0, -2, 0.5, 0, 0, 0], [demo.final; 0, -2, 0.5, 0, 0, 0]);
  steps = withAnchor(demo, blue, wall);
  check(strcmp(steps(1).anchor, 'Wall') && steps(2).stays, 'otherwise that beside what stayed');
  [~, problem] = placeAtAnchor(steps, blue, [], eye);
  check(~isempty(strfind(problem, 'nothing is seen that looks like Wall')), 'which must be seen');
  [~, problem] = placeAtAnchor(steps(1), blue, [], eye);
  check(~isempty(strfind(problem, 'could not be measured')), 'and understood');
  [~, problem] = placeAtAnchor(steps, block([0.5, 0.3, 0.2], [4, 1, 1], 0, -8.5, 0, 0), [], eye);
  check(~isempty(strfind(problem, 'out of reach or out of view')), 'its place must be in view');
  demo.final(1, 3) = 1.5;
  check(isempty(withAnchor(demo, blue, wall)(1).anchor), 'what was put higher was more than put elsewhere');
end
