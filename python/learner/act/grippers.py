"""Which arms can hold a block, how far down, and which is the nearest."""

from constants import ARMS as C, MOTION_PLANNING
from things.held_parts import held_part


def arms_for(steps, arms):
    """Returns the arms whose grippers can hold the blocks of all steps except those that stay.

    Raises ValueError if there are none.
    """
    width = max((held_part(step).size[1] for step in steps if not (step.stays or step.has_knob)), default=0)
    able = [arm for arm in arms if can_hold(arm, width)]
    if not able:
        found = ", ".join(f"{arm.name}: " + (f"{arm.opening:.2f} units" if arm.opening else "none")
                          for arm in arms)
        raise ValueError(f"the robot has no gripper for blocks that are {width:.2f} units wide: "
                         f"found {found}; expected one that opens at least "
                         f"{width + C.opening_margin:.2f} units")
    return able


def can_hold(arm, width):
    """Returns true if the gripper of an arm opens far enough for a width [units]."""
    return arm.opening >= width + C.opening_margin


def nearest_first(arms, x):
    """Returns arms in the order in which they are tried at a place to the right of the middle (x >
    0) or to the left of it: a list."""
    return sorted(arms, key=lambda arm: -arm.foot[0] if x > 0 else arm.foot[0])


def grip_depth(arm, height):
    """Returns how far the tool of an arm is below the top of a block of some height when it grasps
    it [units]; negative above the top. The fingers reach still lower, but not to what the block
    stands on; what carries them stays above the top."""
    return min(max(MOTION_PLANNING.grip_below_top, MOTION_PLANNING.fingers_below_top - arm.reach),
               height - MOTION_PLANNING.fingers_above_bottom - arm.reach, arm.palm - MOTION_PLANNING.palm_clearance)
