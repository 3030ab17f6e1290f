% The program's half of link_test.py: what smilelink gives, takes and refuses.

function id_and_message(id, pattern, varargin)
  try
    smilelink(varargin{:});
  catch err
    assert(err.identifier, id);
    assert(~isempty(regexp(err.message, pattern, 'once')), '%s', err.message);
    return
  end
  error('no error, expected %s', pattern);
end

id_and_message('smile:usage', 'not connected; call', 'receive');
id_and_message('smile:usage', 'expected ''open'', ''receive'' or ''send''', 'shout');
id_and_message('smile:closed', 'cannot connect to /nowhere/door: No such file', 'open', '/nowhere/door');
smilelink('open', getenv('SMILE_BRAIN_ADDRESS'));
tic;
assert(smilelink('receive'), 0);  % nothing comes
assert(toc < 5);

smilelink('send', 1, 0, struct('double', [1 2; 3 4], 'single', single(1.5), 'int', int32([7; 8]), ...
                               'sparse', sparse([0 5]), 'truth', true, 'truths', sparse([true false]), ...
                               'text', 'abc', 'none', [], 'empty', '', 'cube', ones(2, 1, 2)));
[type, sequence, values, is_other] = smilelink('receive');
assert({type, sequence, is_other}, {4, 5, true});
assert(values.double, [1 3 5; 2 4 6]);
assert(values.picture, reshape((0:5) / 255, 1, 2, 3));
assert(values.bytes, uint8([1 2]));
assert(values.truth, true);
assert(values.text, 'xy');
assert(size(values.none), [0 3]);
[~, sequence, ~, is_other] = smilelink('receive');
assert({sequence, is_other}, {6, false});

id_and_message('smile:value', 'c is a cell, expected real numbers', 'send', 5, 6, struct('c', {{1}}));
id_and_message('smile:value', 'z is a complex double, expected', 'send', 5, 6, struct('z', 1i));
id_and_message('smile:value', 'big is 100000x100000, which messages cannot contain', ...
               'send', 5, 6, struct('big', sparse(1e5, 1e5)));
id_and_message('smile:usage', 'expected a scalar struct', 'send', 5, 6, 7);
smilelink('send', 5, 6, struct('after', 1));  % what was refused has left nothing behind

id_and_message('smile:protocol', 'row-major pixels, which were not requested', 'receive');
id_and_message('smile:protocol', 'a message of 4294967295 bytes, expected at most', 'receive');
smilelink('open', getenv('SMILE_BRAIN_ADDRESS'));  % a new one
assert(smilelink('receive'), 8);  % the simulator has closed the connection
id_and_message('smile:closed', 'the simulator has closed the connection', 'send', 5, 6, struct());
disp('all is well');
