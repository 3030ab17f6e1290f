function support = startSupport(demo, n, step, looks)
% Returns what object n of a demonstration stood on at the start, if that tells the object of a step from others that look
% the same, which began on something else ("the red one on the left base"); [] if it tells nothing, or was not seen:
%   like  what it looks like, a block; [] for the table
%   name  of the object in the demonstration, for messages
%   away  of it, from the middle of all objects that look like it, 1x2 [units]
%   looks  appearances of all objects, see measureObjects
  support = [];
  if step.stays || isempty(looks(n).size), return; end
  wanted = looks(n);
  wanted.color = step.color;
  below = supportsOf(demo, n, looks);
  is_other = false;
  for m = setdiff(find(~cellfun(@isempty, {looks.size})), n)
    is_other = is_other || (isSameKind(looks(m), wanted) && ~isequal(supportsOf(demo, m, looks), below));
  end
  if isempty(below) || ~is_other, return; end
  support = struct('like', {[]}, 'name', below{1}, 'away', [0, 0]);
  if strcmp(support.name, 'the table'), return; end
  m = find(strcmp(demo.ids, support.name));
  alike = looks(arrayfun(@(it) ~isempty(it.size) && isSameKind(it, looks(m)), looks));
  positions = vertcat(alike.position);
  support.like = asBlocks(stepOf(demo, m, looks(m), struct('object', {}, 'properties', {})));
  support.away = looks(m).position(1:2) - mean(positions(:, 1:2), 1);
end

function names = supportsOf(demo, n, looks)
% Returns the names of what object n stood on at the start, or 'the table', 1xN cell; empty if it is not known.
  others = setdiff(find(~cellfun(@isempty, {looks.size})), n);
  names = demo.ids(others(arrayfun(@(m) standsOn(looks(n), looks(m)), others)));
  bottom = looks(n).position(3) - looks(n).size(3) / 2;
  if isempty(names) && bottom < constants().task_model.max_support_gap, names = {'the table'}; end
end
