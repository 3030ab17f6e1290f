function table = tableSize()
% Returns width and depth of the table.
  table = [20 12];
end
