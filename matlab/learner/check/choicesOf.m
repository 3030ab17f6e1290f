function choices = choicesOf(aux)
% Returns what is done in a way of its own, where there are several good ways: the seeds that the simulator asks for. [] for
% the way that was demonstrated, or is found first.
%   order  of steps that may be next
%   grasp  of the ways to hold a block
%   path   of how high it is carried
  choices = struct('order', [], 'grasp', [], 'path', []);
  if isfield(aux, 'variationOrder'), choices.order = aux.variationOrder; end
  if isfield(aux, 'variationGrasp'), choices.grasp = aux.variationGrasp; end
  if isfield(aux, 'variationPath'), choices.path = aux.variationPath; end
end
