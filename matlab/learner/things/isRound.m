function yes = isRound(block)
% Returns true for a disc or a ball.
  yes = ~strcmp(block.form, 'block');
end
