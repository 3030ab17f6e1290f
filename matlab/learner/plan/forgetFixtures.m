function state = forgetFixtures(state, picture, heights, eye)
% Forgets unknown objects around controls that the demonstration shows at the same places: they are parts of what the
% controls belong to, like another switch, and not to be moved.
  c = constants().presses;
  surface = surfaceOf(picture, heights, eye);
  for press = state.presses
    alignment = alignmentOf(press, state);
    is_fixture = arrayfun(@(it) any(arrayfun(@(kind) isequal(kind.size, it.size), state.unknownObjects)), state.known);
    for i = find(is_fixture)
      it = state.known(i);
      around = surfaceAround(surface, it.position, min(it.size(1:2)) / 2, c.num_points);
      is_fixture(i) = agreement(around, alignment, press.before, state.shown) > c.min_agreement;
    end
    state.known(is_fixture) = [];
  end
end
