function text = describePress(press)
% Returns what a press of a control, or the use of a tool on it, is called in messages.
  text = ['press of ', press.control];
  if ~isempty(press.tool), text = ['use of ', press.tool.name, ' on ', press.control]; end
end
