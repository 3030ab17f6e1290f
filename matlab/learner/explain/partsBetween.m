function parts = partsBetween(pictures, poses, eye, can_be_round)
% Returns the parts of an object (see measureParts) that two views of it show.
%   pictures  1x2 cell
%   poses     of the object in them, 2x6 [units, degrees]
%   can_be_round  optional: whether discs count
  if nargin < 4, can_be_round = false; end
  parts = noBlocks();
  pixels = {pixelAt(poses(1, 1:3), eye), pixelAt(poses(2, 1:3), eye)};
  colors = reshape(pictures{1}, [], 3);
  for color = frequentColors(pictures{1}, constants().perception.min_rim_pixels)
    if ~all(cellfun(@(picture, it) isColorNear(picture, color', it), pictures, pixels)), continue; end
    masks = cellfun(@(picture) colorMask(picture, color'), pictures, 'UniformOutput', false);
    later = displacedRegions(masks{2}, masks{1});
    for before = displacedRegions(masks{1}, masks{2})
      for after = later
        shown = sub2ind(size(masks{1}), before{1}(:, 1), before{1}(:, 2));
        for part = partOf(median(colors(shown, :), 1), before{1}, after{1}, poses, eye, can_be_round)
          is_new = arrayfun(@(it) norm(it.position - part.position) > constants().parts.max_error, parts);
          if all(is_new), parts(end + 1) = part; end
        end
      end
    end
  end
end

function part = partOf(color, before, after, poses, eye, can_be_round)
% Returns the part that two regions of pixels show in two views; a 1x0 struct array if they show none. The closer to the eye
% a part is, the farther it moves in the picture: its place in the frame of the object grows in proportion to its height,
% differently in each view; at its height both agree.
  c = constants();
  part = noBlocks();
  on_center = placeAt(0, before, poses(1, :), eye) - placeAt(0, after, poses(2, :), eye);
  above = placeAt(1, before, poses(1, :), eye) - placeAt(1, after, poses(2, :), eye);
  growth = above - on_center;
  height = 0;
  if any(growth), height = -(on_center * growth') / (growth * growth'); end
  if ~(height > 0 && height < c.parts.max_height), return; end
  [place, face] = placeAt(height, before, poses(1, :), eye);
  [other, later] = placeAt(height, after, poses(2, :), eye);
  is_part = norm(place - other) < c.parts.max_error && sameSize(face.sides, later.sides) && ...
            max(face.misfit, later.misfit) < c.perception.misfit && (can_be_round || ~face.isRound) && ...
            min(face.sides) > c.parts.min_side;
  if ~is_part, return; end
  part(1) = newBlock(color, [face.sides, 0], [place, height], 0);
  if face.isRound, part.form = 'disc'; end
end

function [place, face] = placeAt(height, pixels, pose, eye)
% Returns where pixels are in the frame of an object at a pose, 1x2 [units], if they are at a height above its center, and
% their face.
  yaw = pose(6) * pi / 180;
  [x, y, area] = ontoPlane(pixels(:, 1), pixels(:, 2), eye, pose(3) + height);
  face = fitFace(x, y, area, yaw);
  place = rotated(face.center - pose(1:2), -yaw);
end
