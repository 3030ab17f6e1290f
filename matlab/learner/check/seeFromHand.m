function state = seeFromHand(state, sensor, arm)
% Adds the blocks that the camera of a hand sees, and the eye does not, to the known ones.
  view = sensor.cameras.(arm.camera);
  eye = struct('intrinsics', view.intrinsics, 'pose', view.pose);
  picture = view.rgb;
  noise = noiseOf(picture);
  if noise > 0, picture = withoutNoise(picture, noise, 1); end
  [like, staying] = likes(state);
  seen = detectBlocks(picture, eye, like, [], heightMap(view.depth, eye), staying);
  is_near = @(it, other) norm(it.position - other.position) <= constants().beliefs.same_block_distance;
  is_known = arrayfun(@(it) any(arrayfun(@(other) is_near(it, other), state.known)), seen);
  new = seen(~is_known);
  for it = fliplr(new), state.known = [it, state.known]; end
  objects = 'objects';
  if numel(new) == 1, objects = 'object'; end
  text = sprintf('%d more %s with the %s hand', numel(new), objects, arm.name);
  state.notes(end + 1) = asNote('saw', text, noBlocks(), new, arm.camera);
end
