function smile_brain()
%SMILE_BRAIN  Runs a brain for the SMILE simulator until the simulator closes the connection.
%
%   The simulator starts this function in Octave or Matlab, with these environment variables:
%     SMILE_BRAIN_TRANSPORT  'socket' (through the compiled SMILELINK) or 'pipes' (SMILE_LINK_PLAIN)
%     SMILE_BRAIN_ADDRESS    the socket, or the folder with the two pipes
%     SMILE_BRAIN_FOLDER     the folder with agentBehavior.m
%     SMILE_BRAIN_SCRATCH    a folder for temporary files; the simulator removes it
%
%   agentBehavior returns handles of two scripts, init and callback. Both run in the base
%   workspace, so that their variables, and sensor, motor and aux, remain between calls.
%   docs/brain-protocol.md describes the messages.

  mlock();  % "clear all" in a program clears the program's things, not ours
  prepare_session();
  if strcmp(getenv('SMILE_BRAIN_TRANSPORT'), 'socket')
    link = @smilelink;
  else
    link = @smile_link_plain;
  end
  message = message_types();
  link('open', getenv('SMILE_BRAIN_ADDRESS'));
  link('send', message.hello, 0, hello());

  while true
    [type, sequence, values] = link('receive');
    switch type
      case message.nothing  % a moment for Ctrl-C
      case message.init
        [callback, image_seconds, arms] = answer_init(link, message, sequence, values);
      case message.step
        answer_steps(link, message, sequence, values, callback, image_seconds, arms);
        return
      case message.bye
        return
    end
  end
end

function message = message_types()
  message = struct('nothing', 0, 'hello', 1, 'init', 2, 'init_done', 3, 'step', 4, ...
                   'motor', 5, 'final_motor', 6, 'error', 7, 'bye', 8);
end

function yes = is_octave()
  persistent answer
  if isempty(answer), answer = exist('OCTAVE_VERSION', 'builtin') ~= 0; end
  yes = answer;
end

function prepare_session()
  motion = fullfile(fileparts(fileparts(mfilename('fullpath'))), 'motion');
  if exist(motion, 'dir'), addpath(motion); end
  addpath(getenv('SMILE_BRAIN_FOLDER'));
  more off
  if is_octave()
    struct_levels_to_print(0);  % or printing a sensor prints its whole image
    if isempty(getenv('DISPLAY'))
      warning('off', 'Octave:gnuplot-graphics');  % that it is discouraged; there is no other
      if any(strcmp(available_graphics_toolkits(), 'gnuplot')), graphics_toolkit('gnuplot'); end
      set(0, 'defaultfigurevisible', 'off');
    end
  end
end

function values = hello()
  values = struct('version', 1, 'language', version(), 'guard', false);
  if is_octave()
    values.client = 'octave';
    if exist('smile_guard') == 3  % lets the simulator end an endless loop with an error
      smile_guard();
      values.guard = true;
    end
  else
    values.client = 'matlab';
  end
end

function [callback, image_seconds, arms] = answer_init(link, message, sequence, aux)
  callback = '';
  image_seconds = [];
  arms = [];
  script = 'agentBehavior';
  try
    [init, callback, files] = load_scripts();
    still = struct();
    if isfield(aux, 'numLimbs')
      still.jointVelocities = zeros(aux.numLimbs, aux.numJoints);
      still.gripperVelocities = zeros(aux.numLimbs, 1);
    end
    if isfield(aux, 'armNames')
      aux = smile_arms('describe', aux);
      arms = smile_arms('layout', aux.arms);
      still.arms = smile_arms('still', aux.arms);
    end
    aux.attention = with_properties(aux.attention);
    if isfield(aux, 'planWords'), aux = with_plan(aux); end
    aux.cameraNames = lines_of(aux.cameraNames);
    assignin('base', 'aux', aux);
    script = init;
    evalin('base', [init ';']);
    assignin('base', 'motor', still);
    aux = base_aux();
    new_markers(aux);
    if isfield(aux, 'imageSeconds'), image_seconds = aux.imageSeconds; end
    link('send', message.init_done, sequence, wishes(aux, files, arms));
  catch err
    report = smile_describe_error(err, script, 'aux');
    if ~isfield(aux, 'numLimbs'), report = smile_arms('hint', report); end
    link('send', message.error, sequence, report);
  end
  if is_octave(), fflush(stdout); end
end

function answer_steps(link, message, sequence, sensor, callback, image_seconds, arms)
  % From the first to the last. This is what every step waits for, and to call a function or to ask
  % isfield takes as long as 5 us: hence what is usual stands here, in a line, and what is rare is
  % in functions.
  needs_flush = is_octave();
  call = [callback ';'];
  type = message.step;
  is_other = true;
  had_markers = true;  % perhaps
  cameras = {};
  aux = base_aux();
  if isfield(aux, 'cameras'), cameras = aux.cameras; end
  while type ~= message.bye
    if type == message.step
      try
        answer = {};
        if is_other
          has_trackers = isfield(sensor, 'trackerNames');
          has_more = isfield(sensor, 'segmentNames') || ...
                     any(strncmp(fieldnames(sensor), 'cameras_', 8));
          has_arms = isfield(sensor, 'armJoints');
          is_classic = isfield(sensor, 'heldObject');
          if is_classic, held = two_lines(sensor.heldObject); end
        end
        if is_classic, sensor.heldObject = held; end
        if has_arms, sensor = smile_sense_arms(sensor, arms); end
        if has_trackers, sensor = with_tracker_map(sensor); end
        if has_more, sensor = with_more_to_see(sensor); end
        assignin('base', 'sensor', sensor);
        evalin('base', call);
        answer = evalin('base', '{motor, aux}', '{motor, struct()}');  % aux may have been cleared
        motor = answer{1};
        if isfield(motor, 'arms'), motor = smile_pack_arms(motor, arms); end
        has = isfield(answer{2}, {'exit', 'drawMarkers', 'imageSeconds', 'claim', 'notes', 'cameras'});
        if has(2) || had_markers
          [is_new, markers] = new_markers(answer{2});
          had_markers = has(2);
          if is_new, motor.drawMarkers = markers; end
        end
        if has(3) && ~isequal(answer{2}.imageSeconds, image_seconds)
          image_seconds = answer{2}.imageSeconds;
          motor.imageSeconds = image_seconds;
        end
        if has(6) && ~isequal(answer{2}.cameras, cameras)
          cameras = answer{2}.cameras;
          motor.cameras = in_one_line(cameras, 'cameras');
        end
        if has(5), motor = with_notes(motor, answer{2}); end
        type = message.motor;
        if has(1) && is_exit_requested(answer{2})
          type = message.final_motor;
          if has(4), motor.claim = answer{2}.claim; end
        end
        link('send', type, sequence, motor);
      catch err
        report = describe(err, callback, answer);
        if ~is_classic, report = smile_arms('hint', report); end
        link('send', message.error, sequence, report);
      end
      if needs_flush, fflush(stdout); end
    end
    [type, sequence, sensor, is_other] = link('receive');
  end
end

function report = describe(err, callback, answer)
  report = smile_describe_error(err, callback, 'motor');
  names = {'motor', 'aux'};
  for k = numel(answer):-1:1
    if ~isstruct(answer{k}) || ~isscalar(answer{k})
      report.message = [names{k} ' is no longer a struct'];
    end
  end
end

function [init, callback, files] = load_scripts()
  % Octave reads a script when it meets its name: a mistake in it shows before anything moves.
  try
    [init_handle, callback_handle] = agentBehavior();
    init = script_name(init_handle, 'first');
    callback = script_name(callback_handle, 'second');
    files = struct('initFile', script_file(init), 'callbackFile', script_file(callback));
  catch err
    if ~smile_mend_break(err), rethrow(err); end
    [init, callback, files] = load_scripts();
  end
end

function name = script_name(handle, which_one)
  if ischar(handle), name = handle; else, name = func2str(handle); end
  name = strrep(name, '@', '');
  if ~isvarname(name)
    error('the %s output of agentBehavior is not the handle of a script, like @myInit', which_one);
  end
end

function file = script_file(name)
  file = strrep(which(name), getenv('SMILE_BRAIN_SCRATCH'), getenv('SMILE_BRAIN_FOLDER'));
  if isempty(file), error('agentBehavior names %s, but %s.m is missing', name, name); end
end

function sensor = with_tracker_map(sensor)
  names = regexp(sensor.trackerNames, '\n', 'split');
  positions = num2cell(sensor.trackerPositions, 2);
  sensor = rmfield(sensor, {'trackerNames', 'trackerPositions'});
  sensor.trackerLoc = containers.Map(names(:), positions(:), 'UniformValues', false);
end

function lines = lines_of(text)
  if isempty(text), lines = {}; else, lines = regexp(text, '\n', 'split'); end
end

function lines = two_lines(text)
  newline = find(text == 10, 1);
  lines = {text(1:newline - 1), text(newline + 1:end)};
  lines(cellfun('isempty', lines)) = {''};  % 0x0, as people write it
end

function sensor = with_more_to_see(sensor)
  if isfield(sensor, 'segmentNames'), sensor.segmentNames = lines_of(sensor.segmentNames); end
  % cameras_overhead_rgb becomes cameras.overhead.rgb.
  names = fieldnames(sensor);
  for k = find(strncmp(names, 'cameras_', 8)).'
    last = find(names{k} == '_', 1, 'last');
    sensor.cameras.(names{k}(9:last - 1)).(names{k}(last + 1:end)) = sensor.(names{k});
    sensor = rmfield(sensor, names{k});
  end
end

function [is_new, markers] = new_markers(aux)
  % Whether the program's markers are others than when this was last asked.
  persistent last
  markers = [];
  if isfield(aux, 'drawMarkers'), markers = aux.drawMarkers; end
  is_new = ~isequal(markers, last);
  last = markers;
end

function attention = with_properties(lines)
  % 'b01,color,size' of each line becomes a struct.
  attention = struct('object', {}, 'properties', {});
  if isempty(lines), return; end
  lines = regexp(lines, '\n', 'split');
  for k = 1:numel(lines)
    words = regexp(lines{k}, ',', 'split');
    attention(k).object = words{1};
    attention(k).properties = words(2:end);
  end
end

function aux = with_plan(aux)
  % What matters in the demonstration becomes one struct.
  words = regexp(aux.planWords, '\n', 'split');
  objects = regexp(aux.planObjects, '\n', 'split');
  subtasks = struct('words', words, 'objects', {{}}, 'segments', [], 'isNecessary', false);
  for k = 1:numel(words)
    if ~isempty(objects{k}), subtasks(k).objects = regexp(objects{k}, ',', 'split'); end
    subtasks(k).segments = aux.planSegments(k, :);
    subtasks(k).isNecessary = aux.planNecessary(k) ~= 0;
  end
  aux.plan = struct('subtasks', subtasks, 'order', aux.planOrder, 'sufficient', aux.planSufficient);
  aux.plan.goals = lines_of(aux.planGoals);
  aux = rmfield(aux, {'planWords', 'planObjects', 'planSegments', 'planNecessary', 'planOrder', ...
                      'planSufficient', 'planGoals'});
end

function aux = base_aux()
  % A program may have cleared it: then it wishes nothing.
  aux = struct();
  if evalin('base', 'exist(''aux'', ''var'')'), aux = evalin('base', 'aux'); end
  if ~isstruct(aux) || ~isscalar(aux), error('aux is no longer a struct'); end
end

function values = wishes(aux, values, arms)
  for name = {'initJointAngles', 'drawMarkers', 'imageSeconds', 'watch'}
    if isfield(aux, name{1}), values.(name{1}) = aux.(name{1}); end
  end
  for name = {'channels', 'cameras'}
    if isfield(aux, name{1}), values.(name{1}) = in_one_line(aux.(name{1}), name{1}); end
  end
  if isfield(aux, 'notes'), values = with_notes(values, aux); end
  if isfield(aux, 'arms') && isfield(aux.arms, 'initJoints')
    values = smile_arms('posture', values, {aux.arms.initJoints}, arms, 'initJoints');
  end
end

function values = with_notes(values, aux)
  % Notes are told once: they are removed from the program's aux.
  if ~isempty(aux.notes)
    values.notes = in_lines(aux.notes, 'notes');
    if isfield(aux, 'noteTops'), values.noteTops = aux.noteTops; end
    if isfield(aux, 'noteCameras'), values.noteCameras = in_lines(aux.noteCameras, 'noteCameras'); end
  end
  told = intersect({'notes', 'noteTops', 'noteCameras'}, fieldnames(aux));
  assignin('base', 'aux', rmfield(aux, told));
end

function text = in_lines(texts, field)
  % Of a cell array of texts, or of one text, one on each line; numbers are left for the simulator to refuse.
  text = texts;
  if iscell(texts)
    if ~iscellstr(texts), error('aux.%s is not a cell array of texts', field); end
    text = strjoin(texts(:).', "\n");
  end
end

function text = in_one_line(names, field)
  % Of a cell array of names, or of one name; numbers are left for the simulator to refuse.
  text = names;
  if isempty(names), text = ''; end
  if iscell(names) && ~isempty(names)
    if ~iscellstr(names), error('aux.%s is not a cell array of names', field); end
    text = strjoin(names(:).', ',');
  end
end

function yes = is_exit_requested(aux)
  yes = any(aux.exit(:) ~= 0);
end
