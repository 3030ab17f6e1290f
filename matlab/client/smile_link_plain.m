function [type, sequence, values] = smile_link_plain(command, varargin)
%SMILE_LINK_PLAIN  SMILELINK without a compiler: messages over a pair of pipes.
%
%   smile_link_plain('open', folder)
%   [type, sequence, values] = smile_link_plain('receive')
%   smile_link_plain('send', type, sequence, values)
%
%   VALUES is a scalar struct of real arrays and text. When the simulator has gone, 'receive' gives
%   its goodbye. docs/brain-protocol.md describes the bytes.

  persistent from_simulator to_simulator
  mlock();
  switch command
    case 'open'
      % In this order: the simulator opens its ends the other way round.
      from_simulator = open_pipe(fullfile(varargin{1}, 'to_brain'), 'r');
      to_simulator = open_pipe(fullfile(varargin{1}, 'from_brain'), 'w');
    case 'receive'
      [type, sequence, values] = receive(from_simulator);
    case 'send'
      body = encode(varargin{3});
      header = uint32([magic(), varargin{1}, varargin{2}, numel(body)]);
      fwrite(to_simulator, [typecast(header, 'uint8').'; body], 'uint8');
      if exist('OCTAVE_VERSION', 'builtin'), fflush(to_simulator); end
    otherwise
      error('smile:usage', 'unknown command %s', command);
  end
end

function number = magic()
  number = hex2dec('31424d53');
end

function pipe = open_pipe(path, mode)
  pipe = fopen(path, mode, 'ieee-le');
  if pipe < 0, error('smile:closed', 'cannot open %s', path); end
end

function [type, sequence, values] = receive(pipe)
  type = 8;  % goodbye, when there is nobody any more
  sequence = 0;
  values = struct();
  header = fread(pipe, 16, '*uint8');
  if numel(header) < 16, return; end
  header = double(typecast(header, 'uint32'));
  if header(1) ~= magic(), error('smile:protocol', 'what arrived is not a message'); end
  body = fread(pipe, header(4), '*uint8');
  if numel(body) < header(4), return; end
  type = header(2);
  sequence = header(3);
  values = decode(body);
end

function values = decode(body)
  values = struct();
  count = double(typecast(body(1:4), 'uint32'));
  at = 8;  % bytes read so far
  for k = 1:count
    head = double(body(at + (1:4)));
    at = at + 4;
    dims = double(typecast(body(at + (1:4 * head(3))), 'uint32')).';
    at = at + 4 * head(3);
    name = char(body(at + (1:head(1)))).';
    at = pad8(at + head(1));
    size_bytes = prod(dims) * (1 + 7 * (head(2) == 0));
    data = body(at + (1:size_bytes));
    at = pad8(at + size_bytes);
    switch head(2)
      case 0, value = typecast(data, 'double');
      case 1, value = data; if head(4) == 1, value = double(data) / 255; end
      case 2, value = data ~= 0;
      case 3, value = char(data);
    end
    values.(name) = reshape(value, dims);
  end
end

function body = encode(values)
  names = fieldnames(values);
  parts = cell(1, numel(names));
  for k = 1:numel(names)
    parts{k} = encode_array(names{k}, values.(names{k}));
  end
  body = [typecast(uint32([numel(names) 0]), 'uint8').'; vertcat(parts{:})];
end

function bytes = encode_array(name, value)
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
  bytes = [head; zeros(pad8(numel(head)) - numel(head), 1, 'uint8'); ...
           data; zeros(pad8(numel(data)) - numel(data), 1, 'uint8')];
end

function text = kind_of(value)
  text = class(value);
  if isnumeric(value), text = ['complex ' text]; end
end

function size = pad8(size)
  size = 8 * ceil(size / 8);
end
