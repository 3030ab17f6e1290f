function found = rimsAt(demo, n, picture, color, is_half_hidden)
% Returns what may be object n of a demonstration, which stands on the table, as a container (see measureContainers): rims of a
% color, 1x3, in a picture, a 1xN struct array or [].
%   is_half_hidden  whether something hides a part of it: then its place and its yaw are those of the texts
  found = [];
  height = 2 * demo.start(n, 3);
  center = demo.start(n, 1:2);
  if is_half_hidden && ~hasShape(demo, n, 'box'), return; end
  if is_half_hidden
    faces = halfHiddenRims(picture, demo.eye, color, height, center, demo.start(n, 6) * pi / 180);
  else
    faces = detectRims(picture, demo.eye, color, height);
  end
  for face = faces
    if norm(face.center - center) > constants().task_model.max_center_error, continue; end
    it = newBlock(color, [face.sides, height], [face.center, height / 2], face.yaw);
    if face.isRound
      it.form = 'disc';
      it.yaw = 0;
    end
    it.name = demo.ids{n};
    it.floor = 0;
    found = [found, it];
  end
end
