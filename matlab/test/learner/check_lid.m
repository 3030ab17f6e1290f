function check_lid()
% A lid with a knob is put beside a pot, a red cube into the pot, and the lid on the pot again.
  red = [1, 0, 0];
  cube = block(red, [1, 1, 1], 3, -3, 0, 0);
  [folder, remove] = newRecording({pictureOf([lid(-2, -2, 1.5), cube]), ...
                                   pictureOf([pot(-2, -2), lid(2, 0, 0), cube]), pictureOf(lid(-2, -2, 1.5))});
  write(folder, '0.txt', {'0,create,Pot,shape,box', '0,create,Lid,shape,composite', '0,create,Red,shape,block', ...
                          '0,move,Pot,-2.0,-2.0,0.75,0.0,0.0,0.0', '0,move,Lid,-2.0,-2.0,1.6,0.0,0.0,0.0', ...
                          '0,move,Red,3.0,-3.0,0.5,0.0,0.0,0.0'});
  write(folder, '1.txt', {'0,grasp,LeftHand,Lid', '1,move,Lid,2.0,0.0,0.1,0.0,0.0,0.0', '1,release,LeftHand', ...
                          '1,grasp,LeftHand,Red', '2,move,Red,-2.0,-2.0,0.7,0.0,0.0,0.0', '2,release,LeftHand', ...
                          '2,grasp,LeftHand,Lid', '2,move,Lid,-2.0,-2.0,1.6,0.0,0.0,0.0', '2,release,LeftHand'});
  [steps, containers] = inferTask(readDemonstration(folder), []);
  check(isequal({steps.name}, {'Red', 'Lid'}) && isequal({steps.after}, {[], 1}), 'a lid covers what is inside');
  check(isequal([steps.hasKnob], [false, true]) && isequal([steps.beginsThere], [false, true]), ...
        'it has a knob and begins where it ends');
  check(max(abs(steps(2).size - [2.8, 2.8, 0.2])) < 0.08, 'it is measured around its knob');

  [picture, heights] = pictureOf([lid(1, -2, 1.5), block(red, [1, 1, 1], -3, -2, 0, 0)]);
  state = observe(initialTaskState(steps, containers), picture, heights, robotEye());
  k = find(~cellfun(@isempty, {state.known.knob}));
  check(norm(heldPart(state.known(k)).position - [1, -2, 2.05]) < 0.05, 'its knob is found in the scene');
  check(numel(graspYaws(state.known(k), noBlocks())) == 4, 'and it is held by it');
  state = chooseSite(state, [], picture, robotEye());
  check(norm(state.containers.position - [1, -2, 0.75]) < 0.05, 'the pot is below the lid');
  [state, used] = assessProgress(state);
  moves = proposeMoves(state, 1, find(~used));
  check(~any(state.done) && moves(1).block == k, 'the lid is taken off before anything is put inside');
end

function blocks = lid(x, y, bottom)
% Returns a lid and its knob.
  blocks = [block([0.75, 0.45, 0.3], [2.8, 2.8, 0.2], x, y, bottom, 0), ...
            block([0, 0, 1], [0.6, 0.6, 0.7], x, y, bottom + 0.2, 0)];
end

function blocks = pot(x, y)
% Returns the floor of a pot and its walls, the far ones first.
  color = [0.5, 0.3, 0.2];
  blocks = [block(color, [2.3, 2.3, 0.2], x, y, 0, 0), block(color, [2.5, 0.2, 1.5], x, y + 1.15, 0, 0), ...
            block(color, [0.2, 2.5, 1.5], x + 1.15, y, 0, 0), block(color, [0.2, 2.5, 1.5], x - 1.15, y, 0, 0), ...
            block(color, [2.5, 0.2, 1.5], x, y - 1.15, 0, 0)];
end
