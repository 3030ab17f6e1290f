function state = knowColors(state, picture, eye, heights, tops)
% Gives what is wanted the colors that it has in a picture, once for each color: one that is seen as it was
% demonstrated stays as it is. What is not seen, or not clearly, is looked for in the next picture.
%   tops  of objects in the picture, as from segmentTopFaces
  if any(isnan(state.unseenColors(:))), state = knowLight(state, picture); end
  things = wantedThings(state);
  wanted = colorsOfThings(things);
  if any(isnan(state.unseenColors(:))), state.unseenColors = wanted; end
  if isempty(state.unseenColors), return; end
  tops = distinctColors(vertcat(zeros(0, 3), tops.color)')';
  is_unseen = @(color) ~isSeen(color, things, tops, picture);
  unseen = state.unseenColors(cellfun(is_unseen, num2cell(state.unseenColors, 2)), :);
  seen = wanted(~cellfun(@(color) isAmong(color, unseen), num2cell(wanted, 2)), :);
  tops = tops(~cellfun(@(color) isNearColor(color, seen), num2cell(tops, 2)), :);
  changes = colorChanges(unseen, tops);
  others = num2cell(state.unknownObjects);  % the wanted ones on other faces
  for k = 1:numel(others), things(end + 1) = setfield(setfield(others{k}, 'isStaying', false), 'isBox', false); end
  for pair = reshape(find(isfinite(changes)), 1, [])
    [i, k] = ind2sub(size(changes), pair);
    if ~looksSo(things, unseen(i, :), tops(k, :), picture, eye, heights), changes(pair) = Inf; end
  end
  columns = clearMatches(changes);
  for i = find(~isnan(columns)), state = withColor(state, unseen(i, :), tops(columns(i), :)); end
  state.unseenColors = unseen(isnan(columns), :);
end

function yes = isSeen(color, things, tops, picture)
% Returns true if a wanted color is seen as it is: in the tops of blocks, or anywhere if it is that of other things.
  yes = any(colorMask(reshape(tops, 1, rows(tops), 3), color));
  if yes, return; end
  alike = things(ofColor(things, color));
  is_block = ~strcmp({alike.form}, 'ball') & cellfun(@isempty, {alike.parts}) & ~[alike.hasKnob] & ~[alike.isBox];
  yes = ~any(is_block) && nnz(colorMask(picture, color)) >= constants().perception.min_top_pixels;
end

function yes = looksSo(things, color, seen, picture, eye, heights)
% Returns true if something of the form and the size of one of some things of a color is seen in another color. Of
% knobs and of things of several colors this is not known before.
  alike = things(ofColor(things, color) & cellfun(@isempty, {things.parts}));
  yes = isempty(alike);
  [alike.color] = deal(seen);
  for box = asBlocks(alike([alike.isBox])), yes = yes || ~isempty(detectContainer(picture, eye, box)); end
  alike = alike(~[alike.isBox]);
  if yes || isempty(alike), return; end
  yes = ~isempty(detectBlocks(picture, eye, asBlocks(alike), [], heights, asBlocks(alike([alike.isStaying]))));
end

function yes = isAmong(color, colors)
% Returns true if a color is exactly one of others, Nx3.
  yes = any(all(colors == color, 2));
end

function yes = isNearColor(color, colors)
% Returns true if a color is the same as one of others, Nx3.
  yes = any(max(abs(colors - color), [], 2) < constants().blocks.same_color);
end
