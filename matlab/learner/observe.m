function state = observe(state, picture, heights, eye)
% Updates the known blocks, the appearances of unknown objects and the unexplained points from a picture.
%   picture  HxWx3, 0 to 1
%   heights  as from heightMap
  container = state.container;
  if ~state.hasSite, container = []; end  % its place in this scene is not known yet
  like = [asBlocks(state.steps), state.unknownObjects];
  staying = asBlocks(state.steps([state.steps.stays] | [state.steps.hasKnob]));
  seen = detectBlocks(picture, eye, like, container, heights, staying);
  [state.steps, seen] = findKnobs(state.steps, seen, picture, eye, heights);
  is_odd = rows(state.unexplained) >= constants().perception.many_unexplained;
  if ~state.hasSite || state.numBlocked > 0 || is_odd
    unknown = detectUnknownObjects(picture, eye, withHeldParts([seen, state.known]), heights);
    state.unknownObjects = [state.unknownObjects, unknown];
    seen = addKnobs(state.steps, detectBlocks(picture, eye, [like, unknown], container, heights, staying));
  end
  state.known = updateBeliefs(state.known, seen, picture, eye, heights);
  state.unexplained = unexplainedPoints(withHeldParts(state.known), heights, eye);
end
