function [keyframes, goal] = explain(demo, appearances, containers)
% Explains a demonstration by facts (see factsAt) at the start and after each of its deeds: what was done, what
% of it is the goal, and what was only a means.
%   keyframes.deed     one line: who did what; empty at the start
%   keyframes.facts    1xN cell
%   keyframes.made     those that were not true before, without what hands hold
%   keyframes.isMeans  true if the deed made something, and nothing of it is kept until the end
%   goal               facts that were made and kept
  effects = {'create', 'initializeControl', 'changeControlState', 'delete', 'attend'};  % lines that are no actions
  world = struct('held', struct(), 'names', {{}}, 'values', {{}});
  keyframes = struct('deed', {}, 'facts', {}, 'made', {}, 'isMeans', {});
  before = {};
  deed = '';  % the last one, whose effects follow; then none until the next
  is_open = true;
  for action = [demo.events, struct('frame', Inf, 'word', 'end', 'fields', {{}})]
    if is_open && ~any(strcmp(action.word, effects))
      keyframes(end + 1) = keyframeAt(deed, before, action.frame, world);
      before = keyframes(end).facts;
      is_open = false;
    end
    next = deedOf(action, world.held, demo.ids);
    if ~isempty(next)
      deed = next;
      is_open = true;
    end
    world = worldAfter(action, world, demo.ids);
  end
  goal = newFacts(keyframes(end).facts, keyframes(1).facts);
  for k = 2:numel(keyframes)
    made = keyframes(k).made;
    keyframes(k).isMeans = ~isempty(made) && ~any(ismember(made, goal));
  end

  function keyframe = keyframeAt(deed, before, frame, world)
    others = strtrim(strcat(world.names, {' '}, world.values));
    if isempty(world.names), others = {}; end
    facts = factsAt(demo, appearances, containers, frame, world.held, others);
    keyframe = struct('deed', deed, 'facts', {facts}, 'made', {newFacts(facts, before)}, 'isMeans', false);
  end
end

function made = newFacts(facts, before)
% Returns the facts that were not true before, without what hands hold.
  made = facts(~ismember(facts, before) & ~strncmp(facts, 'held ', 5));
end

function deed = deedOf(action, held, ids)
% Returns what an action ends, in words; empty if it ends nothing, like a grasp.
  words = struct('release', 'carries', 'trigger', 'triggers', 'use', 'uses', 'fasten', 'fastens', ...
                 'loosen', 'loosens', 'destroy', 'destroys', 'press', 'presses');
  deed = '';
  if ~isfield(words, action.word), return; end
  hand = action.fields{1};
  if strcmp(action.word, 'use') && isfield(words, action.fields{3})
    deed = sprintf('%s %s %s with %s', hand, words.(action.fields{3}), action.fields{[4, 2]});
    return
  end
  object = action.fields(2:min(2, end));
  if any(strcmp(action.word, {'release', 'destroy'}))
    object = {};
    if isfield(held, hand), object = ids(held.(hand)); end
  end
  if isempty(hand), hand = 'something'; end
  deed = strjoin([{hand, words.(action.word)}, object], ' ');
end
