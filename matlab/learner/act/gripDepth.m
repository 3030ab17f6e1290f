function depth = gripDepth(arm, height)
% Returns how far the tool of an arm is below the top of a block of some height when it grasps it [units]; negative above
% the top. The fingers reach still lower, but not to what the block stands on; what carries them stays above the top.
  c = constants().motion_planning;
  depth = min([max(c.grip_below_top, c.fingers_below_top - arm.reach), height - c.fingers_above_bottom - arm.reach, ...
               arm.palm - c.palm_clearance]);
end
