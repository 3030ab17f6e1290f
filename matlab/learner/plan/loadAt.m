function points = loadAt(load, tools)
% Returns the points of a load (see loadOf) where the tool has poses, 4x4xN: those at one pose after those at another, Mx3 [units].
  turned = reshape(load * reshape(permute(tools(1:3, 1:3, :), [2, 1, 3]), 3, []), rows(load), 3, []);
  points = reshape(permute(turned + reshape(tools(1:3, 4, :), 1, 3, []), [1, 3, 2]), [], 3);
end
