function ticks = ticksWithin(seconds, aux)
% Returns the number of whole ticks in some time, as far as a step can last that long.
  ticks = min(max(floor(seconds / aux.tickSeconds), 0), aux.maxTicks);
end
