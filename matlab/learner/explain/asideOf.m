function aside = asideOf(demo, step, appearances)
% Returns where a demonstration put a carried object that ends where it began, last before it came back; [] if that was on the
% table or on blocks.
%   aside.place    the block there
%   aside.before   picture of the demonstration before something was put there, HxWx3
%   aside.changed  mask of the pixels around its middle, HxW logical
%   aside.height   of the center of what was carried there, at its highest [units]
  aside = [];
  if ~step.beginsThere, return; end
  n = find(strcmp(demo.ids, step.name));
  releases = [demo.events(strcmp({demo.events.word}, 'release')).frame];
  frames = releases(demo.placed == n);
  moves = demo.moves(demo.moves(:, 2) == n, [1, 3:8]);
  for frame = fliplr(frames(1:end - 1))
    taken = graspFrames(demo);
    pose = poseBefore(demo, n, min(taken(taken > frame)));
    place = asBlocks(step);
    place.position = pose(1:3);
    place.yaw = step.yaw + (pose(6) - demo.final(n, 6)) * pi / 180;
    others = appearances(setdiff(find(~cellfun(@isempty, {appearances.size})), n));
    is_known = place.position(3) - place.size(3) / 2 < constants().task_model.min_inside_bottom || ...
               any(arrayfun(@(it) standsOn(place, it), others));
    if is_known || isSamePose(pose, demo.final(n, :)), continue; end
    frames = pictureFrames(demo);
    picture = readPicture(demo, max(frames(frames <= min(graspFrames(demo, step.name)))));
    aside = struct('place', place, 'before', picture, 'changed', maskAround(picture, demo.eye, pose(1:3)), ...
                   'height', max(moves(moves(:, 1) <= frame, 4)));
    return
  end
end
