function state = observe(state, picture, heights, eye)
% Updates the known blocks, the appearances of unknown objects and the unexplained points from a picture.
%   picture  HxWx3, 0 to 1
%   heights  as from heightMap
  is_odd = rows(state.unexplained) >= constants().perception.many_unexplained;
  looks_around = ~state.hasSite || state.numBlocked > 0 || is_odd;
  tops = struct('color', {}, 'row', {}, 'column', {});
  if looks_around || ~isempty(state.unseenColors), tops = segmentTopFaces(picture, tableColor(picture), heights); end
  state = knowColors(state, picture, eye, heights, tops);
  containers = state.containers;
  if ~state.hasSite, containers = []; end  % their places in this scene are not known yet
  [like, staying] = likes(state);
  seen = detectBlocks(picture, eye, like, containers, heights, staying);
  [state.steps, seen] = findKnobs(state.steps, seen, picture, eye, heights);
  if looks_around
    unknown = detectUnknownObjects(picture, eye, withHeldParts([seen, state.known]), heights, tops);
    state.unknownObjects = joined(state.unknownObjects, unknown);
    seen = addKnobs(state.steps, detectBlocks(picture, eye, joined(like, unknown), containers, heights, staying));
  end
  state = compare(state, seen, picture, eye, heights);
  state.unexplained = unexplainedPoints(withHeldParts(state.known), heights, eye);
end

function state = compare(state, seen, picture, eye, heights)
% Compares what is expected, the known blocks, with those seen in a picture, and corrects it. If the block that
% was just moved is not where it should be, its grasp failed.
  tolerance = constants().blocks.position_tolerance;
  % What is dropped into a container may lie anywhere inside.
  if ~isempty(state.containers), tolerance = constants().blocks.confined_tolerance; end
  verdicts = verdictsOn(state.known, seen, picture, eye, heights, tolerance);
  if isempty(state.known)
    state.notes(end + 1) = asNote('saw', sprintf('%d objects', numel(seen)), noBlocks(), seen);
  end
  state.notes = [state.notes, verdictNotes(verdicts, seen, state.steps, state.moved)];
  if ~isempty(state.moved) && strcmp(verdicts(end).word, 'contradicted')
    state.failures(end + 1) = state.grasp;
  end
  state.moved = '';
  state.known = corrected(seen, verdicts);
end
