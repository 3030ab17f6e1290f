function frames = graspFrames(demo, name)
% Returns the frames of a demonstration in which hands took an object, or, without its name, any: 1xN.
  grasps = demo.events(strcmp({demo.events.word}, 'grasp'));
  frames = [grasps.frame];
  if nargin > 1, frames = frames(arrayfun(@(it) strcmp(it.fields{2}, name), grasps)); end
end
