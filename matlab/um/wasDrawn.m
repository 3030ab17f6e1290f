function yes = wasDrawn(demo, n)
% Whether object n of a demonstration was only drawn along, like a door, and never lifted or turned. (Of
% one without texts that is not known.)
  c = constants().understand;
  moves = demo.moves(demo.moves(:, 2) == n, 3:8);
  yes = ~isempty(moves) && norm(moves(end, 1:2) - moves(1, 1:2)) > c.drawn_distance && ...
        max(max(abs(moves(:, 3:6) - moves(1, 3:6)))) < c.drawn_wobble;
end
