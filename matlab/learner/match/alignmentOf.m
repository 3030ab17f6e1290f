function alignment = alignmentOf(press, state)
% Returns the alignment (see align) of the surroundings of the control of a press.
  alignment = state.alignments(strcmp({state.alignments.control}, press.control));
end
