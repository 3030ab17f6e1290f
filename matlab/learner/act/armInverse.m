function q = armInverse(arm, pose, q, varargin)
% Returns joint angles that bring an arm's tool to a pose, 4x4, or to several, 4x4xN, searched from q, 1xn [rad]: Nxn; [] if one
% has none.
% Arms of fewer than six joints cannot make up for a rounded description.
  if numel(q) < 6
    tolerance = constants().arms.tolerance;
    varargin = [varargin, {'positionTolerance', tolerance, 'angleTolerance', tolerance}];
  end
  q = smileInverse(arm.robot, arm.name, pose, q, varargin{:});
end
