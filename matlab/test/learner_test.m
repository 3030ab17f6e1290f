% Tests the parts of the learner in matlab/learner, without the simulator:
%
%   octave-cli matlab/test/learner_test.m
%
% prints "ok" or the first wrong claim, and exits with 0 or 1. matlab/test/learner contains the tests, one file for each part;
% python/test/learner contains the same claims about the Python twin.
here = fileparts(mfilename('fullpath'));
addpath(genpath(fullfile(here, '..', 'learner')), fullfile(here, 'learner'));

try
  check_perception();
  check_depth();
  check_forms();
  check_noise();
  check_clearance();
  check_inference();
  check_unstacking();
  check_container();
  check_lid();
  check_dragging();
  check_planning();
  check_site();
  check_meant();
  check_clearing();
  check_making_room();
  check_crowded();
  check_step_choice();
  check_impossible_moves();
  check_hand_looks();
  check_path_over();
  check_points_of_arm();
  check_resting();
  check_failures();
  check_pushes();
  check_parts();
  check_outlines();
  check_light();
  check_presses();
  check_uses();
  check_drives();
catch err
  fprintf('%s\n', err.message);
  exit(1);
end
fprintf('ok\n');
exit(0);
