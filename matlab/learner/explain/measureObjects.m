function appearances = measureObjects(demo, needed)
% Measures the appearance of the objects of a demonstration in its pictures: the texts contain the pose of
% each object in each picture, so its top can be found there. An object began on the table or on a lower one;
% its height is twice the distance of its middle from there.
%   needed       numbers of objects; others are left out, with a size of [], if no picture shows them
%   appearances  a block for each object, at its first place, its sides along its own axes: see newBlock
  appearances = repmat(newBlock([], [], [], 0), 1, numel(demo.ids));
  at_start = noBlocks();  % those measured so far
  pictures = containers.Map('KeyType', 'double', 'ValueType', 'any');  % cache
  [~, order] = sort(demo.start(:, 3));
  order = order(~ismember(order, carriedAlong(demo)));
  for n = order'
    found = measureObject(demo, n, at_start, pictures);
    if ~isempty(found)
      appearances(n) = found;
      at_start(end + 1) = found;
    elseif any(needed == n)
      notUnderstood('no picture of the demonstration shows %s entirely', demo.ids{n});
    end
  end
  % What has the same layout is as high, whatever it stood on.
  for n = find(~cellfun(@isempty, {appearances.parts}))
    like = appearances(arrayfun(@(it) hasPartsOf(appearances(n), it, false), appearances));
    sizes = vertcat(like.size);
    appearances(n).size(3) = min(sizes(:, 3));
  end
end

function block = measureObject(demo, n, lower, pictures)
% Measures an object in the first frame that shows it entirely. Returns it as a block at its first place, a
% 1x0 struct array if there is none.
%   lower     blocks that it may have stood on at the start
%   pictures  cache
  start = demo.start(n, :);
  frames = selectFrames(demo, n);
  unread = frames(~cellfun(@(it) pictures.isKey(it), num2cell(frames(:, 1))), 1);
  for frame = unique(unread)', pictures(frame) = readPicture(demo, frame); end
  uncertain = noBlocks();
  if hasShape(demo, n, 'ring'), block = measureOtherTop(demo, n, lower, frames, pictures); return; end  % its side is in its middle
  tops = arrayfun(@(it) it.position(3) + it.size(3) / 2, lower);
  % A lower block may be below: of a stack, the top of the whole could be that of a high block.
  for bottom = fliplr(unique([0, tops(tops < start(3))]))
    height = 2 * (start(3) - bottom);
    for row = frames'
      [color, sides, form] = measureTop(pictures(row(1)), demo.eye, row(2:7)', height);
      if isempty(sides), continue; end
      block = newBlock(color, [sides, height], start(1:3), start(6) * pi / 180, form);
      is_on = any(arrayfun(@(it) standsOn(block, it), lower));
      middle = row(2:4)' + [0, 0, height / 2];
      if bottom > 0 && (~is_on || isSideAt(pictures(row(1)), demo.eye, middle)), continue; end
      % What is seen elsewhere, too, comes first: an arm at the top of what it hides stays there.
      if movesAlong(color, row(2:7)', frames, height, demo.eye, pictures), return; end
      if isempty(uncertain), uncertain = block; end
    end
  end
  block = uncertain;
  if isempty(block), block = measureBall(demo, n, frames, pictures); end
  if isempty(block), block = measureTopWithKnob(demo, n, frames, pictures); end
  if isempty(block), block = measureCoveredTop(demo, n, pictures); end
  if isempty(block), block = measureParts(demo, n); end
  % What is known by less, like an outline, comes last.
  if isempty(block), block = measureOtherTop(demo, n, lower, frames, pictures); end
end

function block = measureBall(demo, n, frames, pictures)
% Measures an object that may be a ball on the table, like measureObject.
  block = noBlocks();
  start = demo.start(n, :);
  radius = start(3);
  if ~mayBeBall(demo, n), return; end
  for row = frames'
    if isempty(pictures(row(1))), continue; end
    color = ballColor(pictures(row(1)), demo.eye, row(2:4)', radius);
    if isempty(color), continue; end
    block = newBlock(color, 2 * radius * [1, 1, 1], start(1:3), 0, 'ball');
    return
  end
end
