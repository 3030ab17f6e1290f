function notUnderstood(template, varargin)
% Throws that a demonstration shows what this learner does not understand: why, in one line, as for sprintf.
  error('learner:notUnderstood', template, varargin{:});
end
