"""Tells people the notes about the work."""

from check.notes import tops_of


def tell(aux, seconds):
    """Tells the notes that were not told yet: those about actions also in the log."""
    notes, aux.state.notes = aux.state.notes, []
    if not notes:
        return
    for note in notes:
        if note.word not in ("plan", "saw"):
            print(f"{seconds:5.1f} s: {note}")
    aux.notes = [str(note) for note in notes]
    aux.noteTops = tops_of(notes)
    if any(note.camera for note in notes):
        aux.noteCameras = [note.camera for note in notes]
