function check_light()
% What is hidden has no color in this light until it is seen: others of nearly its color have other sizes.
  red = [1, 0, 0]; cube = [1, 1, 1]; slab = [2.4, 1.4, 1];
  [picture, heights] = pictureOf([block(0.8 * red, slab, -3, -2, 0, 0), block(0.7 * red, slab, 3, -2, 0, 0)]);
  wanted = newStep(block(red, cube, 0, -2, 0, 0), 'cube');
  state = knowColors(initialTaskState(wanted, []), picture, robotEye(), heights, segmentTopFaces(picture, tableColor(picture), heights));
  check(isequal(state.steps.color, red) && isequal(state.unseenColors, red), 'none of several others is taken for it');
  [picture, heights] = pictureOf([block(0.8 * red, slab, -3, -2, 0, 0), block(0.7 * red, cube, 3, -2, 0, 0)]);
  state = knowColors(state, picture, robotEye(), heights, segmentTopFaces(picture, tableColor(picture), heights));
  check(max(abs(state.steps.color - 0.7 * red)) < 0.005 && isempty(state.unseenColors), 'it is known when it is seen');
end
