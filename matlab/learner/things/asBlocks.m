function blocks = asBlocks(objects)
% Returns steps, or containers, as plain blocks (see newBlock): obstacles for planning.
  blocks = noBlocks();
  if isempty(objects), return; end
  blocks = rmfield(objects, setdiff(fieldnames(objects), fieldnames(blocks)));
end
