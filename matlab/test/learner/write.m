function write(folder, name, lines)
  file = fopen(fullfile(folder, name), 'w');
  fprintf(file, '%s\n', lines{:});
  fclose(file);
end
