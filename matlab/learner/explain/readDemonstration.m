function demo = readDemonstration(folder)
% Reads the text files of a recording (0.txt, 1.txt, ...).
%   demo.folder  of the recording, with its pictures
%   demo.ids     names of the objects, 1xN cell
%   demo.moves   each logged move, Mx8: frame, number of the object, x y z of its center [units], angles
%                about x, y, z [degrees]
%   demo.start   pose of each object at the beginning, Nx6
%   demo.final   pose of each object at the end, Nx6
%   demo.placed  numbers of the released objects, in the order of release
%   demo.events  all lines except moves, 1xN struct: frame, word ('grasp', 'release', ...), fields, 1xM cell
%   demo.segments  of each of these lines, the number of its text file, 1xN
%   demo.held    numbers of the objects that hands hold at the end, 1xN
%   demo.unclear  what was not understood of it, in words, 1xN cell
%   demo.eye     camera of the observing robot: intrinsics 3x3, pose 4x4 [units], as in aux
  demo = struct('folder', folder, 'ids', {{}}, 'moves', zeros(0, 8), 'placed', [], ...
                'events', struct('frame', {}, 'word', {}, 'fields', {}), 'segments', []);
  held = struct();  % number of the object in each hand
  segment = 0;
  while exist(fullfile(folder, sprintf('%d.txt', segment)), 'file')
    text = fileread(fullfile(folder, sprintf('%d.txt', segment)));
    lines = regexp(text, '[^\r\n]+', 'match');
    for i = 1:numel(lines)
      words = regexp(lines{i}, ',', 'split');  % frame, event, fields of the event
      if ~strcmp(words{2}, 'move')
        demo.events(end + 1) = struct('frame', str2double(words{1}), 'word', words{2}, 'fields', {words(3:end)});
        demo.segments(end + 1) = segment;
      end
      switch words{2}
        case 'create'
          demo.ids{end + 1} = words{3};
        case 'move'
          n = find(strcmp(demo.ids, words{3}));
          demo.moves(end + 1, :) = [str2double(words{1}), n, str2double(words(4:9))];
        case 'grasp'
          held.(words{3}) = find(strcmp(demo.ids, words{4}));
        case 'release'
          demo.placed(end + 1) = held.(words{3});
          held = rmfield(held, words{3});
        case 'destroy'
          if isfield(held, words{3}), held = rmfield(held, words{3}); end
      end
    end
    segment = segment + 1;
  end
  if segment == 0
    error('there is no recording in %s: it has no 0.txt', folder);
  end
  for n = 1:numel(demo.ids)
    poses = uprightAtStart(demo.moves(demo.moves(:, 2) == n, 3:8));
    demo.moves(demo.moves(:, 2) == n, 3:8) = poses;
    demo.start(n, :) = poses(1, :);
    demo.final(n, :) = poses(end, :);
  end
  demo.eye = eyeOf(folder);
  demo.held = unique(cell2mat(struct2cell(held)))';
  demo.unclear = arrayfun(@(n) ['why ', demo.ids{n}, ' is still held at the end'], demo.held, 'UniformOutput', false);
end
