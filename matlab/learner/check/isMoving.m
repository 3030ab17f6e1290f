function [yes, state] = isMoving(state, picture)
% Returns true until nothing has moved in the last few pictures, or there were very many: what swings is looked at when it
% hangs still.
  c = constants().perception;
  is_still = false;
  if ~isempty(state.lastPicture)
    is_still = nnz(max(abs(picture - state.lastPicture), [], 3) > c.max_still_change) < c.max_moving_pixels;
  end
  state.lastPicture = picture;
  state.numLooks = state.numLooks + 1;
  state.numStill = (state.numStill + 1) * is_still;
  yes = state.numStill < c.num_still && state.numLooks < c.max_looks;
end
