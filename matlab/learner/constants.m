function c = constants()
% Returns the constants of the learner, shared with its Python twin: learner/constants.json. A group for
% each Python module. Lengths are in units, colors from 0 to 1; suffixes name other units: _rad, _s,
% _of_255, _pixels. Three numbers of places and heights are a range: first, step, last.
  persistent known;
  if isempty(known)
    here = fileparts(mfilename('fullpath'));
    known = jsondecode(fileread(fullfile(here, '..', '..', 'learner', 'constants.json')));
  end
  c = known;
end
