function yes = isDarkerShade(colors, bright)
% Returns whether colors, Nx3, are darker shades of the same hue, Nx1: those of sides of a block with a bright top.
  c = constants().perception;
  fractions = sum(colors .* bright, 2) / max(sum(bright .^ 2), eps);
  yes = fractions > c.shade(1) & fractions < c.shade(2) & ...
        max(abs(colors - fractions .* bright), [], 2) < c.shade_tolerance;
end
