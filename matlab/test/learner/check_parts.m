function check_parts()
% A thing with a red label is lifted and turned.
  red = [1, 0, 0]; green = [0, 1, 0]; light = [0.85, 0.85, 0.85];
  eye = robotEye();
  [folder, remove] = newRecording({pictureOf(thing(red, 2, -3, 0, 0)), pictureOf(thing(red, 1, -2.5, 0.2, 1.5))});
  write(folder, '0.txt', {'0,create,Thing,shape,composite', '0,move,Thing,2.0,-3.0,0.8,0.0,0.0,0.0'});
  write(folder, '1.txt', {'1,grasp,LeftHand,Thing', sprintf('1,move,Thing,1.0,-2.5,2.3,0.0,0.0,%.12f', 0.2 * 180 / pi)});
  write(folder, '2.txt', {'2,release,LeftHand'});
  kind = measureParts(readDemonstration(folder), 1);
  check(numel(kind.parts) == 2, 'the parts of a thing are what moves with it');
  is_label = arrayfun(@(it) max(abs(it.color - red)) < 0.01, kind.parts);
  check(nnz(is_label) == 1 && max(abs(kind.parts(is_label).position - [0, -0.75, 0.9])) < 0.03, 'a label of a color');
  check(max(abs(kind.parts(~is_label).position - [0, 0.1, 0.9])) < 0.03, 'and a plate, at their places');
  check(max(abs(kind.size - [0.9, 2, 1.6])) < 0.05, 'they are as wide as the thing');

  for yaw = 0.3 + [0, pi]
    [picture, heights] = pictureOf([thing(red, -2, -3, yaw, 0), thing(green, 2, -3, 0, 0)]);
    found = detectLayouts(picture, eye, kind, heights);
    check(numel(found) == 1 && max(abs(found.position - [-2, -3, 0.8])) < 0.03, ...
          'a thing is recognized by the colors and places of its parts');
    check(abs(yawDifference(found, yaw)) < 0.02, 'which tell its direction');
    check(isSameKind(found, kind) && ~isSameKind(block(light, found.size, -2, -3, 0, 0), kind), ...
          'nothing without them looks like it');
    check(isempty(detectUnknownObjects(picture, eye, [found, thing(green, 2, -3, 0, 0)], heights)), ...
          'they are no unknown objects');
  end

  check(abs(yawDifference(kind, kind.yaw + 3)) == 3, 'it does not look the same after half a turn');
  kind.parts = turnedParts(kind.parts, pi);
  check(max(abs(kind.parts(is_label).position - [0, 0.75, 0.9])) < 0.03, 'after which its parts are at other places');
end

function blocks = thing(label, x, y, yaw, bottom)
% Returns a dark block with a light plate on it, and a label of some color at its near end.
  at = @(dx, dy) [x, y] + rotated([dx, dy], yaw);
  part = @(color, size, at, bottom) block(color, size, at(1), at(2), bottom, yaw);
  blocks = [part([0.2, 0.2, 0.2], [0.9, 2.2, 1.6], [x, y], bottom), ...
            part([0.85, 0.85, 0.85], [0.7, 1.2, 0.1], at(0, 0.1), bottom + 1.6), ...
            part(label, [0.9, 0.5, 0.1], at(0, -0.75), bottom + 1.6)];
end
