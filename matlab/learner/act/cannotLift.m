function status = cannotLift()
% Returns how a lift ends if the arm does not keep up.
  status = 'the arm cannot lift it';
end
