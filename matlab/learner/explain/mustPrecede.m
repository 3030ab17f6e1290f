function yes = mustPrecede(needs, step, segment)
% Returns true if a step must be done before what was done in a segment, as far as the plan knows; needs: see needsOf.
  later = sum(needs.firsts <= segment);
  released = needs.releases{strcmp(needs.ids, step.name)};
  earlier = arrayfun(@(it) sum(needs.firsts <= it), released(released < segment));
  yes = any(earlier == later) || any(needs.before(later, earlier));
end
