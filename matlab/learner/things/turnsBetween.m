function turns = turnsBetween(sides, goal, opening)
% Returns by which sides a block must be held in turn to get another size by turns, the fewest: 1xN of 1 or 2, as in
% turnedSize. Returns NaN if a gripper of an opening [units] cannot.
  ways = {zeros(1, 0)};
  reached = {sides};
  k = 0;
  while k < numel(ways)
    k = k + 1;
    turns = ways{k};
    if sameSize(reached{k}, goal), return; end
    if numel(turns) == constants().task_model.max_turns, continue; end
    for held = [2, 1]
      if reached{k}(held) > opening, continue; end
      ways{end + 1} = [turns, held];
      reached{end + 1} = turnedSize(reached{k}, held);
    end
  end
  turns = NaN;
end
