function [init, callback] = agentBehavior()
% Replaces the fuse under a cover that four screws hold, as python/examples/cover does.
%
%   smile run scenes/cover_robot.xml --brain matlab/examples/cover
%
% The first picture of the robot's eye shows where housing, screwdriver, fuses, stand and bin are. From it follows the
% whole task, a list of actions: to follow a motion, or to move a gripper to an opening.
  init = @coverInit;
  callback = @coverCallback;
end
