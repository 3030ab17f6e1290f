function c = constants()
% The numbers of the learner, which it shares with its twin: learner/constants.json.
% Lengths are in units, colors from 0 to 1; a name says where a number has another unit: _rad, _s, _of_255,
% _pixels. Three numbers of places and heights are a range: first, step, last.
  persistent known;
  if isempty(known)
    here = fileparts(mfilename('fullpath'));
    known = jsondecode(fileread(fullfile(here, '..', '..', 'learner', 'constants.json')));
  end
  c = known;
end
