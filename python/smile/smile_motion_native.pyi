"""
Compiled part of smile.motion.
"""
from __future__ import annotations
import numpy
import numpy.typing
import os
import typing
__all__: list[str] = ['InvalidMoment', 'LineFault', 'Robot', 'Trajectory']
class LineFault:
    """
    Reason why the tool cannot follow a line.
    """
    def __repr__(self) -> str:
        ...
    @property
    def fraction(self) -> float:
        """
        completed fraction, from 0 to 1
        """
    @property
    def reason(self) -> str:
        """
        in words
        """
class InvalidMoment:
    """
    Time and reason at which a motion becomes invalid.
    """
    def __repr__(self) -> str:
        ...
    @property
    def reason(self) -> str:
        """
        in words
        """
    @property
    def seconds(self) -> float:
        """
        since the start
        """
class Trajectory:
    """
    Motion of the joints of an arm, or of all arms.
    
    Between points, each joint follows the cubic through their positions and velocities.
    """
    def at(self, seconds: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> tuple:
        """
        Positions and velocities at a time, each n, or Nxn for 'both'.
        
        Of K times, each Kxn, or KxNxn for 'both'. The arm rests at the first point before the start, and at
        the last point after the end.
        """
    @property
    def arm(self) -> str:
        """
        name of the arm, or 'both'
        """
    @property
    def duration(self) -> float:
        """
        seconds
        """
    @property
    def joint_names(self) -> list[str]:
        """
        list of n names; for 'both', those of all arms
        """
    @property
    def positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Kxn, or KxNxn for 'both' [rad; m]
        """
    @property
    def times(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        K times since the start, increasing [s]
        """
    @property
    def velocities(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Kxn, or KxNxn for 'both' [rad/s; m/s]
        """
class Robot:
    """
    Robot model for planning.
    
    Lengths are in the scene's unit, angles in radians; poses are 4x4 matrices of the tool in the world:
    z is the approach direction, y goes across the fingers. Arms have names; 'both' means all arms. An
    arm has n joints. Where all N arms have n joints, arrays for 'both' are Nxn, otherwise the joints of
    all arms in one row.
    """
    def __init__(self, path: os.PathLike | str | bytes, *, base: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, unit: typing.SupportsFloat | typing.SupportsIndex = 1.0, gripper: str = '') -> None:
        """
        Reads a URDF file, and the .robot.json beside it.
        
        base: 4x4, pose of the robot's base in the world [units]; by default the world is the base.
        unit: meters per unit; brains receive it as aux.unit.
        gripper: name of the robot's gripper; by default its default gripper.
        """
    def finger_bounds(self, arm: str, opening: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        """
        Box around what moves when the gripper opens, such as its two fingers, at an opening: 2x3.
        
        The least and the greatest x y z in the frame of the tool [units].
        opening: free width between the sides [units].
        """
    def first_invalid(self, trajectory: Trajectory, *, q_both: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, table: tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] | None = None, held: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> InvalidMoment | None:
        """
        First InvalidMoment of a Trajectory, or None if the trajectory is valid.
        
        A moment is invalid if a joint exceeds a limit, or if the robot touches itself or the table.
        q_both: Nxn as for 'both', positions of the arms that do not move [rad; m]; default: the robot's start angles.
        table: (width, depth) of a table centered at the origin, with its top at z = 0 [units].
        held: 2x3, lower and upper corner of a box around what the arm that moves holds, in the frame of its tool
        [units]; it counts as part of the hand.
        """
    def forward(self, arm: str, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Pose of the tool at n joint positions: 4x4.
        """
    def gripper_middle(self, arm: str, opening: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Place of the middle between both sides of the gripper at an opening, along y of the tool [units].
        
        0 for fingers that slide apart, but not where one jaw is fixed.
        opening: free width between the sides [units].
        """
    def inverse(self, arm: str, goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, any_turn: bool = False, any_rotation: bool = False, position_tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-06, angle_tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-06, max_iterations: typing.SupportsInt | typing.SupportsIndex = 2000, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> typing.Any:
        """
        n joint positions within the limits that put the tool at `goal` (4x4), or None if none are found.
        
        q_start: n positions at which the search starts.
        any_turn: any rotation of the tool about its own axis is accepted.
        any_rotation: any rotation of the tool is accepted; only its position matters. Arms of fewer than
        six joints cannot take every rotation.
        position_tolerance [units], angle_tolerance [rad].
        max_iterations: limit for all attempts together; about 1.5 microseconds each.
        """
    def jacobian(self, arm: str, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Velocity of the tool per joint velocity: 6xn, rows 0..2 along x y z [units/s per rad/s], rows 3..5 about x y z.
        """
    def joint_names(self, arm: str) -> list[str]:
        """
        Names of an arm's joints; for 'both', of all joints.
        """
    def limits(self, arm: str) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
        """
        Lower and upper limits of the joints: two arrays of n, or Nxn for 'both' [rad; m].
        """
    def move_joints(self, arm: str, waypoints: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, speed: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> Trajectory:
        """
        Plans a motion through waypoints, from rest to rest, within all limits: a Trajectory.
        
        arm: may be 'both'.
        waypoints: Kxn, or KxNxn for 'both' [rad; m].
        speed: fraction of the joints' maximum velocities, above 0, at most 1.
        """
    def move_line(self, arm: str, q_from: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, speed: typing.SupportsFloat | typing.SupportsIndex = 1.0, tool_speed: typing.SupportsFloat | typing.SupportsIndex = ..., any_turn: bool = False, any_rotation: bool = False) -> tuple:
        """
        Moves the tool along a straight line to `goal` (4x4): (Trajectory, None), or
        (None, LineFault) if the arm cannot follow the line.
        
        q_from: n, positions at the start [rad; m].
        speed: fraction of the joints' maximum velocities, above 0, at most 1.
        tool_speed: maximum speed of the tool [units/s].
        any_turn: the tool may rotate about its own axis during the motion.
        any_rotation: the tool may rotate in any way.
        """
    def pose(self, arm: str, name: str) -> typing.Any:
        """
        Angles of a named pose of the robot, such as 'untucked'; None if it has no pose of that name.
        """
    def why_unreachable(self, arm: str, goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, any_turn: bool = False) -> str:
        """
        Reason why inverse() returns None, for people: str.
        """
    @property
    def arms(self) -> list[str]:
        """
        names of the arms
        """
