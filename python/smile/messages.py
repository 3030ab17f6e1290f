"""Messages between simulator and brain (docs/brain-protocol.md).

All languages share the C++ implementation of connection, frames and checks (src/brain_client, src/wire).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from smile.native import load

if TYPE_CHECKING:
    from smile import smile_brain_native as _native
else:
    _native = load("smile_brain_native")

HELLO, INIT, INIT_DONE, STEP = _native.HELLO, _native.INIT, _native.INIT_DONE, _native.STEP
MOTOR, FINAL_MOTOR, ERROR, BYE = _native.MOTOR, _native.FINAL_MOTOR, _native.ERROR, _native.BYE
Connection = _native.Connection
ProtocolError = _native.ProtocolError
encode, decode = _native.encode, _native.decode
