function check_drives()
% A screw holds a cover: what turns it, and where the cover is put until it comes back.
  [folder, remove] = newRecording({zeros(480, 640, 3)});
  write(folder, '0.txt', {'0,create,Cover,shape,composite', '0,create,Screw,shape,composite', '0,create,Driver,shape,composite', ...
                          '0,move,Cover,-2,-2,1.15,0,0,0', '0,move,Screw,-3,-1.2,1.3,0,0,0', '0,move,Driver,5,-3,1.4,0,0,0', ...
                          '1,grasp,RightHand,Driver', '2,move,Driver,5,-3,3.2,0,0,0', '4,move,Driver,-3,-1.2,3,0,0,0', ...
                          '4.5,move,Screw,-3,-1.2,1.4,0,0,0', '4.5,move,Driver,-3,-1.2,2.9,0,0,0', ...
                          '4.5,use,RightHand,Driver,loosen,Screw', '5,use,RightHand,Driver,loosen,Screw', ...
                          '5.5,move,Driver,5,-3,1.4,0,0,0', '6,release,RightHand', '7,grasp,RightHand,Cover', ...
                          '8,move,Cover,-2,-2,2.6,0,0,0', '8,move,Screw,-3,-1.2,2.8,0,0,0', '9,move,Cover,3,-2,0.95,0,0,90', ...
                          '10,release,RightHand', '11,grasp,RightHand,Cover', '12,move,Cover,-2,-2,1.15,0,0,0', ...
                          '13,release,RightHand', '14,grasp,RightHand,Driver', '15,use,RightHand,Driver,fasten,Screw', ...
                          '15.5,move,Driver,5,-3,1.4,0,0,0', '16,release,RightHand'});
  demo = readDemonstration(folder);
  check(isequal(carriedAlong(demo), 2), 'a screw goes where its cover goes');
  check(~mayBeBall(demo, 1), 'of several shapes');
  knob = block([0.5, 0.5, 0.5], [0.8, 0.4, 1.5], -2, -2, 0.4, 0);
  appearances = [knob, newBlock([], [], [], 0), newBlock([0, 0, 1], [0.7, 0.7, 2.4], [5, -3, 1.4], 0, 'disc')];
  cover = stepOf(demo, 1, knob, struct('object', {}, 'properties', {}));
  cover.aside = asideOf(demo, cover, appearances);
  check(max(abs(cover.aside.place.position - [3, -2, 0.95])) < 1e-9 && cover.aside.height == 2.6, 'where it was put aside');
  for it = {cover.aside.place, cover.aside.place, asBlocks(cover); false, true, false}
    [actions, ~, reason] = planReturning(it{1}, cover, it{2}, initialTaskState(cover, []), struct('index', {}), []);
    is_there = it{1}.position(1) == 3 && ~it{2};
    check(isempty(actions) && strcmp(reason, 'it is put aside already') == is_there, 'it stays aside until it comes back');
  end
  checkReturning(cover);
  drives = inferDevices(demo, cover, appearances);
  check(numel(drives) == 2 && isempty(drives(1).after) && isequal(drives(2).after, 1), 'two drives, before and after');
  check([drives(1).turns.number, drives(2).turns.number] == [2, 1], 'of two turns and of one');
  check(drives(1).turns.isLoosening && ~drives(2).turns.isLoosening, 'the first loosens');
  check(max(abs(drives(1).turns.place - [-3, -1.2, 2.85])) < 1e-9, 'half way between where it began and after a turn');
  check(strcmp(describePress(drives(1)), 'loosening of Screw with Driver'), 'in words');
  state = initialTaskState(cover, [], drives, robotEye());
  state.known = asBlocks(drives(1).tool);
  drives(1).grasp = newGrasp([5, -3, 1.4], struct('index', 1), 0);
  check(~wasDriven(drives(1), state), 'not yet done');
  drives(1).attempts = 1;
  check(wasDriven(drives(1), state), 'done');
  state.failures(end + 1) = drives(1).grasp;
  check(~wasDriven(drives(1), state), 'not done if it failed');
  state.failures(end).tooHeavy = asBlocks(drives(1).tool);
  check(~wasDriven(drives(1), state), 'also because the tool was too heavy');
  checkHands();
end

function checkHands()
% How deep fingers reach, and how far wrists turn.
  plate = block([0.9, 0.9, 0.9], [2.6, 2.2, 0.3], 0, -2, 1, 0);
  [picture, heights] = pictureOf([plate, block([0.5, 0.5, 0.5], [0.8, 0.4, 0.6], 0, -2, 1.3, 0)]);
  knob = withDepth(block([0.5, 0.5, 0.5], [0.8, 0.4, 1.5], 0, -2, 0.4, 0), surfaceOf(picture, heights, robotEye()));
  check(abs(knob.depth - 0.55) < 0.02, 'fingers stay above what is beside');
  turn = constants().uses.turn_rad / 2;
  hand = struct('middle', 0.1, 'strokesPerTurn', 2, 'clockwise', turn);
  [first, last, number] = strokesOf(hand, struct('isLoosening', false, 'number', 2));
  check(abs(last - first - turn) < 1e-9 && number == 5, 'clockwise to fasten, with one stroke more');
  [first, last, number] = strokesOf(hand, struct('isLoosening', true, 'number', 2));
  check(abs(first - last - turn) < 1e-9 && number == 4, 'and back to loosen');
  check(abs(directed(knob, 3) - pi) < 1e-9, 'of two directions the nearer one');
end

function checkReturning(cover)
% What comes back is brought beside others, or alone.
  eval('function pose = toolPose(varargin), pose = eye(4); end');
  eval('function path = planPathThrough(arm, poses, others, varargin), path = [poses, {numel(others)}]; end');
  eval('function q = solvePoses(arm, varargin), q = arm.starts; end');
  remove = onCleanup(@() clear('-f', 'toolPose', 'planPathThrough', 'solvePoses'));
  arm = struct('index', 1, 'opening', 9, 'reach', 0.7, 'palm', 0.75, 'foot', [0, 0], 'starts', 0, 'parked', []);
  for others = {noBlocks(), block([0.5, 0.5, 0.5], [0.5, 0.5, 3], 5, -4, 0, 0)}
    state = initialTaskState(cover, []);
    state.known = others{1};
    [actions, place] = planReturning(cover.aside.place, cover, true, state, arm, struct('arms', struct('joints', [])));
    check(~isempty(actions) && max(abs(place.position - cover.position)) < 1e-9, 'it is brought back');
    check(isequal(actions{end - 1}.path, numel(others{1})), 'past the others');
  end
end
