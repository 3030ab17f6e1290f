function demo = readDemonstration(folder)
% What the text files of a recording (0.txt, 1.txt, ...) say.
%   demo.ids     names of the objects, 1xN cell
%   demo.colors  their colors, 1xN cell; '' where the log names none
%   demo.poses   where each was at the end, Nx6: x y z in units, three angles in degrees
%   demo.placed  numbers of the objects that a hand let go of, in that order
  demo = struct('ids', {{}}, 'colors', {{}}, 'poses', zeros(0, 6), 'placed', []);
  held = struct();  % which object is in which hand
  segment = 0;
  while exist(fullfile(folder, sprintf('%d.txt', segment)), 'file')
    text = fileread(fullfile(folder, sprintf('%d.txt', segment)));
    lines = regexp(text, '[^\n]+', 'match');
    for i = 1:numel(lines)
      words = regexp(lines{i}, ',', 'split');  % frame, event, fields of the event
      switch words{2}
        case 'create'
          n = numel(demo.ids) + 1;
          demo.ids{n} = words{3};
          demo.colors{n} = valueOf(words(4:end), 'color');
          demo.poses(n, :) = NaN;
        case 'move'
          n = find(strcmp(demo.ids, words{3}));
          demo.poses(n, :) = str2double(words(4:9));
        case 'grasp'
          held.(words{3}) = find(strcmp(demo.ids, words{4}));
        case 'release'
          demo.placed(end + 1) = held.(words{3});
      end
    end
    segment = segment + 1;
  end
  if segment == 0
    error('there is no recording in %s: it has no 0.txt', folder);
  end
end

function value = valueOf(pairs, name)
% From {name, value, name, value, ...}.
  value = '';
  i = find(strcmp(pairs(1:2:end), name), 1, 'last');
  if ~isempty(i), value = pairs{2 * i}; end
end
