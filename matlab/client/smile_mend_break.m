function mended = smile_mend_break(err)
%SMILE_MEND_BREAK  Makes a script with a `break` outside any loop acceptable to Octave.
%   Matlab ends the script at such a `break`; Octave reports a parse error, ERR. Puts a copy with
%   `return` instead before the original on the path. Returns TRUE if another attempt can succeed. Call
%   it before the brain runs, so that nothing happens twice.

  mended = false;
  place = regexp(err.message, 'parse error near line (\d+) of file ([^\n]*)', 'tokens', 'once');
  if isempty(place) || isempty(strfind(err.message, 'break must appear within a loop')), return; end
  file = strtrim(place{2});

  lines = regexp(fileread(file), '\n', 'split');
  number = str2double(place{1});
  if number > numel(lines), return; end
  line = regexprep(lines{number}, '\<break\>', 'return');
  if strcmp(line, lines{number}), return; end
  lines{number} = line;

  [~, script] = fileparts(file);
  copy = fullfile(getenv('SMILE_BRAIN_SCRATCH'), [script '.m']);
  out = fopen(copy, 'w');
  if out < 0, return; end
  fwrite(out, strjoin(lines, '\n'));
  fclose(out);
  addpath(getenv('SMILE_BRAIN_SCRATCH'));
  clear(script);
  rehash();
  mended = true;
end
