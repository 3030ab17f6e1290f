function tracker = newTracker(kinds, palette, eye)
% Returns the blocks of a demonstration, as far as the pictures have shown them, before the first one.
%   kinds, palette, eye  see learnKinds, newPalette
%   objects   1xN struct array:
%     kind     number of its kind
%     start    where it was at the start, a block; [] if that was hidden
%     block    where it rests now; [] in a hand
%     placed   where hands put it, 1xM struct array: frame, block
%     seen     how much of its top was visible when its place was measured, see fitVisible
%     numLooks how often its place was measured again
%     doubted  where it may rest, as placed
%   free      pixels that showed the background in some picture, HxW logical; [] before the first
%   wasStill  whether the scene was still in the previous picture
%   before    blocks that seemed to rest in the previous picture
%   view      of all that rest, see expectedView
  objects = struct('kind', {}, 'start', {}, 'block', {}, 'placed', {}, 'seen', {}, 'numLooks', {}, 'doubted', {});
  tracker = struct('kinds', {kinds}, 'palette', palette, 'eye', eye, 'objects', {objects}, 'free', [], 'wasStill', true, ...
                   'before', {noBlocks()}, 'view', []);
end
