function blocks = noBlocks()
% Returns an empty list of blocks, a 1x0 struct array; each has
%   color     1x3, red green blue, 0 to 1
%   size      its longer side, the shorter one, and its height [units]
%   position  of its center, 1x3 [units]
%   yaw       of its longer side [rad]
  blocks = struct('color', {}, 'size', {}, 'position', {}, 'yaw', {});
end
