function places = placesOnOthers(block, others, needed, eye)
% Returns places for a block on others that are as large, flat and free, and that no step needs, within the eye's view, the
% closest first: where a crowded table has no room, what stands on it has.
%   needed  blocks existing or planned, which may need one like them
  canCarry = @(it) isFlat(it) && all(it.size(1:2) > block.size(1:2) - constants().task_planning.max_overhang) && ...
                   ~hasObjectsOn(it, others) && ~any(arrayfun(@(other) isSameKind(it, other), needed));
  carriers = others(arrayfun(canCarry, others));
  [~, order] = sort(arrayfun(@(it) norm(it.position(1:2) - block.position(1:2)), carriers));
  places = noBlocks();
  for it = carriers(order)
    place = block;
    place.position = it.position + [0, 0, (it.size(3) + block.size(3)) / 2];
    place.yaw = it.yaw;
    if isInView(footprint(place, 0), place.position(3) + place.size(3) / 2, eye), places(end + 1) = place; end
  end
end

function yes = isFlat(block)
% Returns true if all of the top of a block is level.
  yes = ~isRound(block) && ~block.hasKnob && isempty(block.parts) && isempty(block.outline);
end
