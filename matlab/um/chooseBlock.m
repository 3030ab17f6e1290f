function [block, aside] = chooseBlock(step, free)
% The block to move next, of those that are in no step's place: one that looks like the step's, or, with
% aside true, one that must go first because it lies where the step's block shall go, or on the only
% block that looks right. [] if there is none.
  block = [];
  aside = false;
  fits = find(arrayfun(@(other) isLike(other, step), free));
  in_way = find(overlap(gripRoom(step), footprint(free, 0)))';
  others = setdiff(in_way, fits);
  if ~isempty(others)
    i = others(1);
  elseif ~isempty(fits)
    distance = arrayfun(@(i) norm(free(i).position - step.position), fits);
    distance(ismember(fits, in_way)) = 0;
    [~, order] = sort(distance);
    i = fits(order(1));
  else
    % Perhaps it is below something.
    i = find(arrayfun(@(other) other.position(3) > other.size(3), free), 1);
    if isempty(i), return; end
  end
  % What lies on a block goes first.
  is_higher = arrayfun(@(other) other.position(3) > free(i).position(3) + 0.5, free);
  on_top = find(is_higher' & overlap(footprint(free(i), 0), footprint(free, 0)));
  aside = ~isempty(on_top) || isempty(fits) || ~isempty(others);
  if ~isempty(on_top), i = on_top(1); end
  block = free(i);
end
