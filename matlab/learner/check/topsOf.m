function rows = topsOf(notes)
% Returns the tops of the blocks of notes, as aux.noteTops: Nx9.
  rows = zeros(0, 9);
  for k = 1:numel(notes)
    blocks = [notes(k).expected, notes(k).found];
    for i = 1:numel(blocks)
      it = blocks(i);
      rows(end + 1, :) = [k, i > numel(notes(k).expected), it.position(1:2), ...
                          it.position(3) + it.size(3) / 2, it.size(1:2), it.yaw, ...
                          isRound(it)];
    end
  end
end
