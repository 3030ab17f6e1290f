function [steps, problem] = placeAtAnchor(steps, known, arms, eye)
% Moves steps that have an anchor to where they stand relative to it. If it is not seen, or if the places are out of reach
% or out of the eye's view, problem says so.
  problem = '';
  name = steps(1).name;
  anchor = steps(1).anchor;
  if strcmp(anchor, 'the table')
    [sites, cost] = deal({steps}, 0);
  elseif ~strcmp(steps(end).name, anchor)
    problem = sprintf('%s, beside which %s goes, could not be measured in the demonstration', anchor, name);
    return
  else
    [sites, cost] = sitesByAnchor(steps, known, eye);
  end
  if isempty(sites)
    problem = sprintf('nothing is seen that looks like %s, beside which %s goes', anchor, name);
    return
  end
  is_visible = cellfun(@(moved) areInView(moved(~[moved.stays]), eye), sites);
  steps = firstWithinReach(cost(is_visible), sites(is_visible), arms);
  if isempty(steps), problem = sprintf('relative to %s, the place of %s is out of reach or out of view', anchor, name); end
end

function yes = areInView(steps, eye)
  yes = all(arrayfun(@(step) isOnTable(footprint(step, 0), eye) && ...
                             isInView(footprint(step, 0), step.position(3) + step.size(3) / 2, eye), steps));
end
