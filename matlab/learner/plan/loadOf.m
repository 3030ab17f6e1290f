function load = loadOf(whole, tool)
% Returns what a hand carries, when it took an object with the tool at a pose, 4x4: points on it in the frame of the tool, Nx3
% [units].
%   whole  points on it, Nx3 [units]
  load = (whole - tool(1:3, 4)') * tool(1:3, 1:3);
end
