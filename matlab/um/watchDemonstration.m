function demo = watchDemonstration(folder)
% What a recording without texts tells to who watches its pictures: the same as readDemonstration, except
% that it knows no single moves, and
%   demo.looks  color and size of each object, as from measureObjects
% Objects are named by their colors. Nothing is known of the demonstrator: an arm is something that hides
% blocks, or looks like one.
  eye = eyeOf(folder);
  objects = trackBlocks();
  before = noBlocks();  % those of the picture before
  kinds = [];
  judged = containers.Map();
  free = false;  % pixels that showed, in some picture so far, that nothing was there
  for look = worthLooking(folder)
    picture = double(imread(look.file)) / 255;
    table = tableColor(picture);
    tops = topsIn(picture, table);
    if isempty(kinds), kinds = learnKinds(tops, picture, eye, table); end
    if isempty(kinds)
      error('%s shows no block that lies by itself, so how large blocks are is not known', look.file);
    end
    seen = recognize(tops, eye, kinds, judged);
    if ~look.isQuiet, seen = lessClear(seen); end
    resting = seen(look.isQuiet | arrayfun(@(block) stays(block, before), seen));
    objects = trackBlocks(objects, resting, @(block) showsTable(picture, eye, block, table), ...
                          @(block) isFree(free, eye, block));
    before = seen;
    free = free | isBackground(picture, table);
  end
  demo = struct('folder', folder, 'ids', {namesOf(objects)}, 'moves', zeros(0, 8), 'eye', eye, ...
                'start', vertcat(objects.start), 'looks', rmfield(objects, {'start', 'position', 'yaw', 'pixels', 'placed'}));
  places = vertcat(objects.position);
  demo.final = [places, zeros(size(places, 1), 2), vertcat(objects.yaw) * 180 / pi];
  [when, order] = sort([objects.placed]);
  demo.placed = order(when > 0);
end

function looks = worthLooking(folder)
% The pictures to look at, in order: all of them; if they are very many, those during which nothing
% moves, for the frame after them needed none of its own, and of the others some.
%   looks  1xN struct array with file and isQuiet
  enough = 150;
  lines = regexp(fileread(fullfile(folder, 'frames.csv')), '[^\r\n]+', 'match');
  images = regexprep(lines(2:end), '^[^,]*,[^,]*,', '');
  has = ~cellfun(@isempty, images);
  if ~any(has), error('there are no pictures in %s', folder); end
  is_quiet = has & [~has(2:end), true];
  which = find(has);
  which = which(is_quiet(which) | mod(1:numel(which), ceil(numel(which) / enough)) == 0);
  files = cellfun(@(image) fullfile(folder, image), images(which), 'UniformOutput', false);
  looks = struct('file', files, 'isQuiet', num2cell(is_quiet(which)));
end

function yes = stays(block, before)
% Whether a block is where one was in the picture before.
  yes = any(arrayfun(@(other) sameColor(other.color, block.color) && ...
                              norm(other.position - block.position) < 0.05, before));
end

function seen = recognize(tops, eye, kinds, judged)
% The blocks whose tops these are, and how many pixels of each are seen. One of a color that no known
% block has is as large as some known one.
%   judged  tops of pictures before, and what they were: from picture to picture most stay the same
  seen = struct('color', {}, 'size', {}, 'position', {}, 'yaw', {}, 'pixels', {});
  for top = tops
    key = sprintf('%g ', top.color, numel(top.row), sum(top.row), sum(top.column), top.row(1), top.column(1));
    if ~judged.isKey(key)
      of = kinds(arrayfun(@(kind) sameColor(kind.color, top.color), kinds));
      if isempty(of)
        of = kinds;
        [of.color] = deal(top.color);
      end
      found = fitBlocks(top.row, top.column, eye, of, [], @(block) true);
      [found.pixels] = deal(numel(top.row));
      judged(key) = found;
    end
    seen = [seen, judged(key)];
  end
end

function seen = lessClear(seen)
% One that moves, if only the last bit to its place, is not quite where it will be, and may be nearer to
% the eye and so seem larger.
  for k = 1:numel(seen), seen(k).pixels = 0.9 * seen(k).pixels; end
end

function yes = isBackground(picture, table)
  yes = all(picture == 0, 3) | isColor(picture, table);
end

function yes = isFree(free, eye, block)
% Whether at a block's place, at the middle of its top, once nothing was.
  spot = pixelAt(block.position + [0, 0, block.size(3) / 2], eye);
  yes = ~isscalar(free) && free(spot(2), spot(1));
end

function names = namesOf(objects)
  names = cell(1, 0);
  for k = 1:numel(objects)
    word = colorName(objects(k).color);
    names{k} = sprintf('%s %d', word, 1 + sum(strncmp(names, [word, ' '], numel(word) + 1)));
  end
end
