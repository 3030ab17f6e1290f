function [type, sequence, values, is_other] = smile_link_plain(command, varargin)
%SMILE_LINK_PLAIN  SMILELINK without a compiler: messages over a pair of pipes.
%
%   smile_link_plain('open', folder)
%   [type, sequence, values, is_other] = smile_link_plain('receive')
%   smile_link_plain('send', type, sequence, values)
%
%   VALUES is a scalar struct of real arrays and text; IS_OTHER is false if names, shapes and texts equal
%   those of the previous message. After the simulator has closed the connection, 'receive' returns its
%   goodbye. docs/brain-protocol.md describes the bytes.

  persistent from_simulator to_simulator is_octave
  mlock();
  switch command
    case 'open'
      is_octave = exist('OCTAVE_VERSION', 'builtin') ~= 0;
      % In this order: the simulator opens its ends the other way round.
      from_simulator = open_pipe(fullfile(varargin{1}, 'to_brain'), 'r');
      to_simulator = open_pipe(fullfile(varargin{1}, 'from_brain'), 'w');
    case 'receive'
      [type, sequence, values, is_other] = receive(from_simulator);
    case 'send'
      fwrite(to_simulator, frame_of(varargin{:}), 'double');
      if is_octave, fflush(to_simulator); end
    otherwise
      error('smile:usage', 'unknown command %s', command);
  end
end

function number = magic()
  number = 826428755;  % the letters SMB1
end

function pipe = open_pipe(path, mode)
  pipe = fopen(path, mode, 'ieee-le');
  if pipe < 0, error('smile:closed', 'cannot open %s', path); end
end

function [type, sequence, values, is_other] = receive(pipe)
  type = 8;  % goodbye, after the simulator has ended
  sequence = 0;
  values = struct();
  is_other = true;
  header = fread(pipe, 16, '*uint8');
  if numel(header) < 16, return; end
  header = double(typecast(header, 'uint32'));
  if header(1) ~= magic(), error('smile:protocol', 'the received bytes are not a message'); end
  body = fread(pipe, header(4), '*uint8');
  if numel(body) < header(4), return; end
  type = header(2);
  sequence = header(3);
  [values, is_other] = decode(body);
end

function [values, is_other] = decode(body)
  % Consecutive steps usually have the same heads: they are read again only when they differ.
  persistent layout
  is_other = isempty(layout) || numel(body) ~= layout.size || ...
             any(body(layout.outline) ~= layout.expected);
  if is_other, layout = layout_of(body); end
  values = layout.values;
  doubles = typecast(body, 'double');
  for k = 1:numel(layout.names)
    elements = layout.first(k):layout.last(k);
    switch layout.kind(k)
      case 0, value = doubles(elements);
      case 1, value = body(elements);
      case 2, value = body(elements) ~= 0;
      case 4, value = double(body(elements)) / 255;
    end
    if numel(elements) ~= 1, value = reshape(value, layout.dims{k}); end
    values.(layout.names{k}) = value;
  end
end

function layout = layout_of(body)
  % Where the arrays of numbers are; the rest, texts too, stays the same as long as the outline does.
  layout = struct('size', numel(body), 'values', struct(), 'names', {{}}, 'kind', [], ...
                  'first', [], 'last', [], 'dims', {{}}, 'outline', [], 'expected', []);
  is_number = false(size(body));
  at = 8;  % bytes read so far
  for k = 1:double(typecast(body(1:4), 'uint32'))
    head = double(body(at + 1:at + 4));
    at = at + 4;
    dims = double(typecast(body(at + 1:at + 4 * head(3)), 'uint32')).';
    at = at + 4 * head(3);
    name = char(body(at + 1:at + head(1))).';
    at = pad8(at + head(1));
    count = prod(dims);
    bytes = at + 1:at + count * (1 + 7 * (head(2) == 0));
    layout.values.(name) = [];
    if head(2) == 3
      layout.values.(name) = reshape(char(body(bytes)), dims);
    else
      is_number(bytes) = true;
      layout.names{end + 1} = name;
      layout.dims{end + 1} = dims;
      layout.kind(end + 1) = head(2) + 3 * (head(4) == 1);  % 4 for fractions
      before = at / (1 + 7 * (head(2) == 0));
      layout.first(end + 1) = before + 1;
      layout.last(end + 1) = before + count;
    end
    at = pad8(at + numel(bytes));
  end
  layout.outline = find(~is_number);
  layout.expected = body(layout.outline);
end

function frame = frame_of(type, sequence, values)
  % The bytes of the message, eight in a double. Only the numbers of the last one are replaced
  % where nothing else has changed.
  persistent last
  names = fieldnames(values);
  arrays = struct2cell(values);
  shapes = [cellfun('ndims', arrays), cellfun('size', arrays, 1), cellfun('size', arrays, 2), ...
            cellfun('prodofsize', arrays)];
  are_plain = all(cellfun('isclass', arrays, 'double')) && all(cellfun('isreal', arrays)) && ...
              ~any(cellfun(@issparse, arrays));
  if ~are_plain || isempty(last) || numel(names) ~= numel(last.names) || ...
     ~all(strcmp(names, last.names)) || any(shapes(:) ~= last.shapes(:))
    [body, data] = encode(names, arrays);
    header = uint32([magic(), type, sequence, numel(body)]);
    frame = typecast([typecast(header, 'uint8').'; body], 'double');
    last = struct('names', {names}, 'shapes', shapes, 'frame', frame, 'data', {data});
    if ~are_plain, last = []; end
    return
  end
  frame = last.frame;
  header = uint32([magic(), type, sequence, 8 * numel(frame) - 16]);
  frame(1:2) = typecast(header, 'double');
  for k = 1:numel(arrays)
    frame(last.data{k}) = arrays{k};
  end
end

function [body, data] = encode(names, arrays)
  % And where in the frame each array has its elements, counted in doubles.
  parts = cell(1, numel(names));
  data = cell(1, numel(names));
  at = 16 + 8;
  for k = 1:numel(names)
    [parts{k}, head_bytes] = encode_array(names{k}, arrays{k});
    data{k} = (at + head_bytes) / 8 + (1:numel(arrays{k}));
    at = at + numel(parts{k});
  end
  body = [typecast(uint32([numel(names) 0]), 'uint8').'; vertcat(parts{:})];
end

function [bytes, head_bytes] = encode_array(name, value)
  if ischar(value)
    type = 3;
    data = uint8(value(:));
  elseif islogical(value)
    type = 2;
    data = uint8(full(value(:)));
  elseif isnumeric(value) && isreal(value)
    type = 0;
    data = reshape(typecast(double(full(value(:))), 'uint8'), [], 1);
  else
    error('smile:value', '%s is a %s, expected real numbers', name, kind_of(value));
  end
  dims = size(value);
  head = [uint8([numel(name); type; numel(dims); 0]); typecast(uint32(dims), 'uint8').'; ...
          uint8(name(:))];
  head_bytes = pad8(numel(head));
  bytes = [head; zeros(head_bytes - numel(head), 1, 'uint8'); ...
           data; zeros(pad8(numel(data)) - numel(data), 1, 'uint8')];
end

function text = kind_of(value)
  text = class(value);
  if isnumeric(value), text = ['complex ' text]; end
end

function size = pad8(size)
  size = 8 * ceil(size / 8);
end
