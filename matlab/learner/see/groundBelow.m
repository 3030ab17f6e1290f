function ground = groundBelow(top, picture, eye, heights)
% Returns the height of what a block stands on [units]: below the edge of its top one of its sides is
% visible, and below that the ground. [] if something else hides its foot; so it is with the floor of a box.
%   top      as from segmentTopFaces
%   heights  as from heightMap
  ground = [];
  c = constants().perception;
  height = median(heights(sub2ind(size(heights), top.row, top.column)));
  [u, v, step] = edgeTowardNadir(top, eye);
  while ceil(u) >= 1 && ceil(u) <= size(heights, 2) && ceil(v) >= 1 && ceil(v) <= size(heights, 1)
    color = reshape(picture(ceil(v), ceil(u), 1:3), 1, 3);
    if ~isDarkerShade(color, top.color)
      below = heights(ceil(v), ceil(u));
      if below <= height - c.on_table, ground = below * (below > c.on_table); end
      return
    end
    u = u + step(1);
    v = v + step(2);
  end
end
