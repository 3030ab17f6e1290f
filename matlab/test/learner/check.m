function check(is_true, claim)
  if ~is_true, error('not so: %s', claim); end
end
