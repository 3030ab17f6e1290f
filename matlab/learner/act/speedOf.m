function speed = speedOf(aux)
% Returns the factor of the speed of motions that the simulator asks for; 1 without one.
  speed = 1;
  if isfield(aux, 'variationSpeed'), speed = aux.variationSpeed; end
end
