function report = smile_describe_error(err, script, variable)
%SMILE_DESCRIBE_ERROR  Message and place of an error, for people.
%   SCRIPT is the running script, VARIABLE the struct with its results. The place is
%   the innermost line of the program's own folder: an error raised inside a library function
%   belongs to the line that called it.

  report = struct('message', err.message, 'file', '', 'line', 0, 'stack', '');
  folder = getenv('SMILE_BRAIN_FOLDER');
  scratch = getenv('SMILE_BRAIN_SCRATCH');
  for k = 1:numel(err.stack)
    file = strrep(err.stack(k).file, scratch, folder);
    report.stack = [report.stack sprintf('%s:%d\n', file, err.stack(k).line)];
    if isempty(report.file) && strncmp(file, [folder filesep], numel(folder) + 1)
      report.file = file;
      report.line = err.stack(k).line;
    end
  end

  % Octave reports the place of a parse error only in the text:
  %   parse error near line 2 of file /home/me/wave/waveInit.m
  %
  %     syntax error
  %
  %   >>> x = = 2
  %           ^
  place = regexp(err.message, 'parse error near line (\d+) of file ([^\n]*)', 'tokens', 'once');
  if ~isempty(place)
    report.line = str2double(place{1});
    report.file = strrep(strtrim(place{2}), scratch, folder);
    lines = strtrim(regexp(err.message, '\n', 'split'));
    is_message = ~cellfun('isempty', lines) & ~strcmp(lines, '^');
    is_message(1) = false;
    report.message = strjoin(strrep(lines(is_message), '>>> ', ''), ': ');
  end

  if strcmp(err.identifier, 'smile:value')
    report.message = [variable '.' strrep(report.message, 'smilelink: ', '')];
  end
  if isempty(report.file), report.file = fullfile(folder, [script '.m']); end
  % The report already contains the place.
  report.message = regexprep(report.message, ' near line \d+, column \d+', '');
  if isempty(report.message), report.message = 'an error without a message'; end
end
