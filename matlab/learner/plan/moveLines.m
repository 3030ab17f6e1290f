function path = moveLines(arm, path, poses)
% Returns paths, and straight lines from the last of them through tool poses; {} if there are none.
  if isempty(path), return; end
  for pose = poses
    path{end + 1} = moveLine(arm, path{end}, pose{1});
    if isempty(path{end})
      path = {};
      return
    end
  end
end
