"""The arms of the robot: what they reach and hold, and how their actions are executed tick by tick."""
