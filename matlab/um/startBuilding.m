function building = startBuilding(steps, container)
% What the brain remembers of the building.
%   steps      see understand; once a site is chosen, where they shall be in this scene
%   container  that some of them go into, see measureContainer; once a site is chosen, where it is here
%   hasSite
%   known      the blocks, where they were last seen; see findBlocks
%   strangers  others that are none of the steps', what they look like; where they are is among known
%   done       whether each step's block is in its place, 1xN
%   tries      how often each step's block was carried there so far, 1xN
%   tidied     how often blocks were put somewhere else
%   miss       by how much each block was off when last seen: [units, rad], Nx2
%   stuck      how many steps in a row could not be gone on with, and
%   trouble    why the first of them could not
%   summary    one line for people, at the end
  n = numel(steps);
  building = struct('steps', steps, 'container', {container}, 'hasSite', false, 'known', noBlocks(), ...
                    'strangers', noBlocks(), 'done', false(1, n), 'tries', zeros(1, n), 'tidied', 0, ...
                    'miss', NaN(n, 2), 'stuck', 0, 'trouble', '', 'summary', '');
end
