function check_watching()
% What the pictures of a demonstration show without texts. After [], the scene did not change for a while.
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1]; yellow = [1, 1, 0];
  cube = [1, 1, 1];
  plank = [4, 1, 1];

  % What a hand hides is understood when it moves on. It hides the left end of the plank, then a block does until the end.
  start = [block(yellow, plank, -2, 2, 0, 0), block(red, cube, 2, -1, 0, 0)];
  aside = block(green, cube, 2, 1.5, 0, 0);
  placed = block(yellow, plank, -1, -1, 0, 0);
  on_it = block(red, cube, -2.5, -1, 1, 0);
  demo = watch({withHand(pictureOf([start, aside]), [2.4, 1.5, 1], 30), ...
                withHand(pictureOf([block(yellow, plank, -1, 1, 1.5, 0), start(2), aside]), [-1, 1, 3], 30), ...
                withHand(pictureOf([placed, start(2), aside]), [-2.5, -1, 1], 36), [], ...
                withHand(pictureOf([placed, block(red, cube, 1, -0.5, 2, 0), aside]), [-2.5, -1, 1], 20), ...
                withHand(pictureOf([placed, on_it, aside]), [-2.5, -1, 2], 30), [], ...
                withHand(pictureOf([placed, on_it, block(green, cube, 0.5, 0, 2.5, 0)]), [0.5, 0, 3], 30), ...
                withHand(pictureOf([placed, block(green, cube, 0.5, -1, 1, 0), on_it]), [0.1, -1, 2], 12), []});
  [steps, containers, appearances] = inferTask(demo, []);
  check(isequal({steps.name}, {'Yellow1', 'Red1', 'Green1'}), 'all blocks are understood in their order');
  check(isequal({steps.on}, {[], 1, 1}), 'and what they stand on');
  places = vertcat(steps.position);
  check(max(max(abs(places - [-1, -1, 0.5; -2.5, -1, 1.5; 0.5, -1, 1.5]))) < 0.05, 'and their places');
  check(numel(explain(demo, appearances, containers)) == 4, 'there are three deeds');
  check(isempty(demo.unclear), 'nothing else is there');

  % What is seen last counts.
  start = [block(blue, [1.8, 1.6, 0.2], 0, 0, 0, 0.3), block(red, cube, 0, 0, 0.2, 0.3)];
  demo = watch({pictureOf(start), pictureOf([start(1), block(red, cube, 1, 0, 1.5, 0)]), ...
                pictureOf([start(1), block(red, cube, 3, -1, 0, 0)]), [], ...
                pictureOf([start(1), block(red, cube, 1, 0, 2, 0)]), pictureOf(start), []});
  steps = inferTask(demo, []);
  check(isequal({steps.name}, {'Blue1', 'Red1'}) && isequal([steps.stays], [true, false]), 'a plate stays below a block');
  check(isequal(steps(2).on, 1) && max(abs(steps(1).size - [1.8, 1.6, 0.2])) < 0.03, 'that is put back on it');
  check(isequal(demo.ids(demo.placed), {'Red1', 'Red1'}), 'after it was put aside');

  % A place of which too little is visible is not guessed.
  start = [block(yellow, plank, -2, 2, 0, 0), block(red, cube, 4, -3.5, 0, 0)];
  hidden = withHand(pictureOf([block(red, cube, 4, 1, 0, 0), block(yellow, plank, 0, -1, 0, 0)]), [-1.6, -1, 1], 24);
  demo = watch({pictureOf(start), pictureOf([block(yellow, plank, -1, 1, 1.5, 0), start(2)]), ...
                withHand(hidden, [1.6, -1, 1], 24), []});
  check(isequal(demo.ids, {'Red1'}) && isequal(demo.placed, 1), 'what can be in two places is not guessed');
  check(isequal(demo.unclear, {'what else is yellow at the end'}), 'it is said that something was not understood');

  % A color that pixels show as two is one: 127 and 128 of 255.
  gray = block([0.5, 0.5, 0.5], [1.6, 1.2, 1.5], -1, 1, 0, 0);
  demo = watch({striped(pictureOf([block(red, cube, 2, -1, 0, 0), gray])), ...
                striped(pictureOf([gray, block(red, cube, -1, 1, 1.5, 0)])), []});
  steps = inferTask(demo, []);
  check(isequal({steps.name}, {'Gray1', 'Red1'}) && isequal({steps.on}, {[], 1}), 'a gray that shows as two grays is one');
end

function picture = striped(picture)
% Returns a picture of which every second column shows another gray where it is half as bright as white.
  is_gray = all(picture == 0.5, 3);
  is_gray(:, 2:2:end) = false;
  picture(repmat(is_gray, 1, 1, 3)) = 127 / 255;
end

function picture = withHand(picture, point, width)
% Returns a picture in which something shaded hides what is around a point.
  at = round(toPixel(point, robotEye()));
  in_rows = max(at(2) - 30, 0) + 1:at(2) + 30;
  in_columns = max(at(1) - width, 0) + 1:at(1) + width;
  shade = repmat(linspace(0.7, 1, numel(in_columns)), numel(in_rows), 1);
  picture(in_rows, in_columns, :) = shade .* reshape([0.85, 0.65, 0.52], 1, 1, 3);
end

function demo = watch(pictures)
% Returns the demonstration in some pictures.
  shows = ~cellfun(@isempty, pictures);
  [folder, remove] = newRecording({});
  lines = {'frame,tick,image'};
  for k = 1:numel(pictures)
    file = '';
    if shows(k)
      file = sprintf('%d.png', k - 1);
      imwrite(uint8(255 * pictures{k}), fullfile(folder, file));
    end
    lines{end + 1} = sprintf('%d,%d,%s', k - 1, k - 1, file);
  end
  write(folder, 'frames.csv', lines);
  demo = watchDemonstration(folder);
end
