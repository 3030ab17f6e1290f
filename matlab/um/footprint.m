function rectangle = footprint(block, margin)
% What a block covers, seen from above, with a margin on all sides [units]: a struct with center 1x2,
% sides 1x2 and yaw, for overlap().
  rectangle = struct('center', block.position(1:2), 'sides', block.size(1:2) + 2 * margin, ...
                     'yaw', block.yaw);
end
