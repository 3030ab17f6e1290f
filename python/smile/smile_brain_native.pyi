"""
Compiled part of smile.messages.
"""
from __future__ import annotations
import typing
__all__: list[str] = ['BYE', 'Connection', 'ERROR', 'FINAL_MOTOR', 'HELLO', 'INIT', 'INIT_DONE', 'MOTOR', 'ProtocolError', 'STEP', 'SimulatorGone', 'decode', 'encode']
class ProtocolError(ValueError):
    pass
class SimulatorGone(BrokenPipeError):
    pass
class Connection:
    """
    The socket to the simulator.
    """
    @staticmethod
    def of_socket(fd: typing.SupportsInt | typing.SupportsIndex) -> Connection:
        """
        Takes the descriptor of a connected, blocking socket, and closes it in the end.
        """
    def __init__(self, address: str) -> None:
        ...
    def greet(self, client: str, language: str, guard: bool) -> None:
        """
        Sends HELLO. guard: SIGUSR2 interrupts a brain that takes too long.
        """
    def receive(self) -> tuple:
        """
        Returns type, sequence and values of the next message; BYE when the simulator has closed the connection.
        """
    def send(self, kind: typing.SupportsInt | typing.SupportsIndex, sequence: typing.SupportsInt | typing.SupportsIndex, values: dict) -> None:
        """
        Sends a message; values as for encode().
        """
def decode(frame: bytes) -> tuple:
    """
    Returns type, sequence and values of a message given as bytes.
    
    Text becomes str, 1x1 a number, everything else an array in numpy's order.
    """
def encode(kind: typing.SupportsInt | typing.SupportsIndex, sequence: typing.SupportsInt | typing.SupportsIndex, values: dict) -> bytes:
    """
    Returns a message as bytes.
    
    values: dict from names to str, numbers or arrays of numbers; numbers are sent as doubles.
    """
BYE: int = 8
ERROR: int = 7
FINAL_MOTOR: int = 6
HELLO: int = 1
INIT: int = 2
INIT_DONE: int = 3
MOTOR: int = 5
STEP: int = 4
