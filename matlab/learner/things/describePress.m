function text = describePress(press)
% Returns what a press of a control, or the use of a tool on it, is called in messages.
  text = ['press of ', press.control];
  if ~isempty(press.turns)
    words = {'fastening', 'loosening'};
    text = [strjoin(words(unique(1 + [press.turns.isLoosening], 'stable')), ' and '), ' of ', strjoin({press.turns.fastener}, ', '), ' with ', press.tool.name];
  elseif ~isempty(press.tool), text = ['use of ', press.tool.name, ' on ', press.control]; end
end
