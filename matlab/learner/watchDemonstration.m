function demo = watchDemonstration(folder)
% Reconstructs a demonstration from the pictures of a recording without texts: as readDemonstration, but
% without single moves, and with
%   demo.appearances  as from measureObjects
% Objects are named by their colors. There is no model of the demonstrator: an arm occludes blocks, or is
% taken for one.
  eye = eyeOf(folder);
  objects = trackBlocks();
  before = noBlocks();  % the blocks in the previous picture
  kinds = [];
  cache = containers.Map();
  free = false;  % pixels that were background in some picture so far
  for frame = picturesToWatch(folder)
    picture = double(imread(frame.file)) / 255;
    table = tableColor(picture);
    tops = segmentTopFaces(picture, table);
    if isempty(kinds), kinds = learnBlockKinds(tops, picture, eye, table); end
    if isempty(kinds)
      error('%s shows no block by itself, so the sizes of the blocks are unknown', frame.file);
    end
    seen = recognizeBlocks(tops, eye, kinds, cache);
    if ~frame.isQuiet, seen = lessReliable(seen); end
    resting = seen(frame.isQuiet | arrayfun(@(block) stays(block, before), seen));
    objects = trackBlocks(objects, resting, @(block) isTableVisible(picture, eye, block, table), ...
                          @(block) isFree(free, eye, block));
    before = seen;
    free = free | isBackground(picture, table);
  end
  appearances = noBlocks();
  for it = objects, appearances(end + 1) = newBlock(it.color, it.size, it.position, it.yaw); end
  demo = struct('folder', folder, 'ids', {namesOf(objects)}, 'moves', zeros(0, 8), 'eye', eye, ...
                'start', vertcat(objects.start), ...
                'appearances', appearances);
  places = vertcat(objects.position);
  demo.final = [places, zeros(size(places, 1), 2), vertcat(objects.yaw) * 180 / pi];
  [when, order] = sort([objects.placed]);
  demo.placed = order(when > 0);
end

function yes = stays(block, before)
% Returns true if a block of this color was at the same place in the previous picture.
  yes = any(arrayfun(@(other) sameColor(other.color, block.color) && ...
                              norm(other.position - block.position) < 0.05, before));
end

function seen = lessReliable(seen)
% Reduces the pixel counts of blocks seen during motion: such a block may not be quite at its final place,
% and may appear larger because it is closer to the eye.
  for k = 1:numel(seen), seen(k).pixels = 0.9 * seen(k).pixels; end
end

function yes = isBackground(picture, table)
% Returns the mask, HxW logical, of the pixels that show the table or nothing.
  yes = all(picture == 0, 3) | colorMask(picture, table);
end

function yes = isFree(free, eye, block)
% Returns true if the middle of a block's top was background in some picture before.
  pixel = pixelAt(block.position + [0, 0, block.size(3) / 2], eye);
  yes = ~isscalar(free) && free(pixel(2), pixel(1));
end

function names = namesOf(objects)
% Returns names for objects, 1xN cell: color and number.
  names = cell(1, 0);
  for k = 1:numel(objects)
    word = colorName(objects(k).color);
    names{k} = sprintf('%s %d', word, 1 + sum(strncmp(names, [word, ' '], numel(word) + 1)));
  end
end
