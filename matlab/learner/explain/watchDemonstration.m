function demo = watchDemonstration(folder)
% Reconstructs a demonstration from the pictures of a recording without texts: as readDemonstration, and with
%   demo.appearances  as from measureObjects
%   demo.unclear      what else the last picture shows that nothing explains, in words, 1xN cell
  eye = eyeOf(folder);
  pictures = picturesOf(folder);
  palette = newPalette(codesIn(pictures(1).file));
  % The first picture, those of a still scene, and the next one after each.
  is_telling = [true, pictures(1:end - 1).isStill] | [pictures.isStill];
  [kinds, palette] = learnKinds({pictures(is_telling).file}, palette, eye);
  if isempty(kinds), notUnderstood('no picture of the demonstration shows a block by itself'); end
  tracker = newTracker(kinds, palette, eye);
  for it = pictures
    [classes, palette] = classesOf(codesIn(it.file), palette);
    tracker = trackPicture(tracker, it.frame, classes, it.isStill);
  end
  demo = demonstrationOf(folder, eye, tracker.objects(~cellfun(@isempty, {tracker.objects.block})), kinds);
  if isempty(demo.placed)
    notUnderstood(['the pictures of the demonstration show no block that moved: without texts, only upright blocks of one ', ...
                   'color are understood']);
  end
  view = expectedView(restingBlocks(tracker.objects), size(classes), eye);
  unclear = unclearColors(classes, view, kinds, palette);
  demo.unclear = arrayfun(@(k) ['what else is ', lower(wordOf(unclear(k, :))), ' at the end'], 1:rows(unclear), 'UniformOutput', false);
end

function demo = demonstrationOf(folder, eye, objects, kinds)
% Returns the demonstration of what tracked objects did: a hand takes each and puts it where it rested next. How it moved in
% between the pictures may not show: it counts as lifted.
  c = constants().watching;
  demo = struct('folder', folder, 'ids', {namesOf(objects, kinds)}, 'moves', zeros(0, 8), 'placed', [], ...
                'events', struct('frame', {}, 'word', {}, 'fields', {}), 'eye', eye, 'appearances', noBlocks());
  deeds = zeros(0, 4);  % frame, height, number of the place and of the object
  for n = 1:numel(objects)
    it = objects(n);
    first = it.start;
    above = 0;
    if isempty(first)
      first = it.placed(1).block;
      above = c.lifted;
    end
    demo.appearances(n) = first;
    demo.events(n) = struct('frame', 0, 'word', 'create', 'fields', {demo.ids(n)});
    demo.moves(n, :) = [0, n, poseAbove(first, above)];
    for k = 1:numel(it.placed), deeds(end + 1, :) = [it.placed(k).frame, it.placed(k).block.position(3), k, n]; end
  end
  % Deeds that end in the same picture are one after the other, the lower one first.
  deeds = sortrows(deeds);
  for k = 1:rows(deeds)
    when = deeds(k, 1) + c.between * (k - 1);
    n = deeds(k, 4);
    block = objects(n).placed(deeds(k, 3)).block;
    demo.events(end + 1) = struct('frame', when, 'word', 'grasp', 'fields', {{'Hand', demo.ids{n}}});
    demo.events(end + 1) = struct('frame', when, 'word', 'release', 'fields', {{'Hand'}});
    demo.moves(end + 1:end + 2, :) = [when, n, poseAbove(block, c.lifted); when, n, poseAbove(block, 0)];
    demo.placed(end + 1) = n;
  end
  for n = 1:numel(objects)
    poses = demo.moves(demo.moves(:, 2) == n, 3:8);
    demo.start(n, :) = poses(1, :);
    demo.final(n, :) = poses(end, :);
  end
end

function pose = poseAbove(block, above)
% Returns the pose of a block, raised by a height, 1x6: x y z [units], angles about x, y, z [degrees].
  pose = [block.position + [0, 0, above], 0, 0, block.yaw * 180 / pi];
end

function names = namesOf(objects, kinds)
% Returns names for tracked objects, 1xN cell: their colors, and numbers.
  names = cell(1, 0);
  for k = 1:numel(objects)
    word = wordOf(kinds(objects(k).kind).color);
    names{k} = sprintf('%s%d', word, 1 + sum(strcmp(regexprep(names, '\d+$', ''), word)));
  end
end
