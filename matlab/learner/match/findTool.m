function [best, tool] = findTool(use, known, surface, shown)
% Returns the number of the known block that is the tool of a use (see newPress), and the tool, turned so that its surroundings
% look as in the demonstration: a bar looks the same after half a turn, what is at its ends does not. [] if there is none.
%   surface  see surfaceOf
%   shown    the eye of the demonstration
  c = constants().uses;
  best = [];
  tool = noBlocks();
  highest = -1;
  for i = find(arrayfun(@(it) isSameKind(it, use.tool), known))
    for turn = [0, pi]
      angle = use.tool.yaw - known(i).yaw - turn;
      place = use.tool.position(1:2) - rotated(known(i).position(1:2), angle);
      near = surfaceAround(surface, known(i).position, c.tool_radius, c.num_points);
      share = agreement(near, struct('angle', angle, 'place', place), use.before, shown);
      if share <= highest, continue; end
      highest = share;
      best = i;
      tool = known(i);
      tool.yaw = tool.yaw + turn;
    end
  end
end
