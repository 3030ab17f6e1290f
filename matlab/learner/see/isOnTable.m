function yes = isOnTable(places, eye)
% Returns which of N places, Nx5 as from footprint, are entirely on the table: Nx1 logical.
  yes = all(all(abs(cornersOfPlaces(places)) <= eye.table / 2, 2), 3);
end
