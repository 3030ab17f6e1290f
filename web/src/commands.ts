// Made by tools/generate.py from the program's tables: change src/sim/command.h instead.

/** It takes hold of an object. */
export interface GraspCommand {
  do: "grasp";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** id of a whole object */
  object: string;
  /** where to take hold of it; its origin if not given [units] */
  point?: [number, number, number];
}

/** It carries the held object. */
export interface MoveToCommand {
  do: "move_to";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** where the grasped point shall go [units] */
  position: [number, number, number];
  /** at most this fast; 10 if not given [units/s] */
  speed?: number;
}

/** It turns the vertical plane in which the hand is dragged. */
export interface PlaneCommand {
  do: "plane";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** of its horizontal direction from the x axis, counterclockwise seen from above [degrees] */
  angle: number;
}

/** It turns the held object about its origin. */
export interface RotateCommand {
  do: "rotate";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** about the world's x, then y, then z axis [degrees] */
  angles: [number, number, number];
}

/** It lets go of the held object. */
export interface ReleaseCommand {
  do: "release";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
}

/** It takes the held object out of the world. */
export interface DestroyCommand {
  do: "destroy";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
}

/** It tells which properties of the held object matter, instead of what was told before. */
export interface AttendCommand {
  do: "attend";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** color, shape, size, position, orientation, order, names of its descriptions; [] = none in particular */
  properties: string[];
}

/** It points at an object or a pointable part; only the log knows. */
export interface PointCommand {
  do: "point";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** id of the object or part */
  part: string;
}

/** It presses a switch or triggers a custom control, with an empty hand. */
export interface TriggerCommand {
  do: "trigger";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** id of the control */
  control: string;
  /** its button (ID-b1 or ID-b2) or part; whatever leads on if not given */
  part?: string;
}

/** It fastens an object one stage tighter. */
export interface FastenCommand {
  do: "fasten";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** id of the object; the held one if the hand holds any */
  object: string;
  /** near its guest point that is meant; the object's origin if not given [units] */
  point?: [number, number, number];
}

/** It loosens an object one stage. */
export interface LoosenCommand {
  do: "loosen";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** id of the object; the held one if the hand holds any */
  object: string;
  /** near its guest point that is meant; the object's origin if not given [units] */
  point?: [number, number, number];
}

/** It sets the robot's speeds until the next such command. */
export interface JointVelocitiesCommand {
  do: "joint_velocities";
  /** left arm, s0 s1 e0 e1 w0 w1 w2 [rad/s] */
  left?: number[];
  /** right arm [rad/s] */
  right?: number[];
  /** rate of change of each opening, left and right [units/s] */
  grippers?: [number, number];
  /** pan [rad/s] */
  head?: number;
}

/** It puts the robot's joints there at once. */
export interface JointAnglesCommand {
  do: "joint_angles";
  /** left arm, s0 s1 e0 e1 w0 w1 w2 [rad] */
  left?: number[];
  /** right arm [rad] */
  right?: number[];
  /** pan [rad] */
  head?: number;
}

/** It turns one joint of the robot until it is told otherwise; the others go on. */
export interface TurnCommand {
  do: "turn";
  /** its name, like left_e1; no finger */
  joint: string;
  /** 0 stops it [rad/s] */
  velocity: number;
}

/** It opens or closes a gripper of the robot until it is told otherwise. */
export interface GripperCommand {
  do: "gripper";
  /** left, right or both */
  arm: "left" | "right" | "both";
  /** rate of change of the opening; above 0 opens [units/s] */
  velocity: number;
}

/** It moves the robot's arms and head straight to a named pose; grippers stay. */
export interface PoseCommand {
  do: "pose";
  /** one of the poses in the robot's side file */
  name: string;
  /** share of the joints' full speed; 0.5 if not given */
  speed?: number;
}

/** It lets joints of the robot follow a trajectory; a script may name a file in place of it. */
export interface TrajectoryCommand {
  do: "trajectory";
  /** their names; left_gripper and right_gripper are openings */
  joints: string[];
  /** seconds since it began, positions [rad; an opening in m], velocities (in all points or in none) */
  points: { seconds: number; positions: number[]; velocities?: number[] }[];
}

/** It shows or hides the robot; physics is not changed. */
export interface RobotCommand {
  do: "robot";
  /** true or false */
  shown: boolean;
}

/** It changes the robot's face, for people to see; physics is not changed. */
export interface FaceCommand {
  do: "face";
  /** idle, watching, working, puzzled or done */
  mood: "idle" | "watching" | "working" | "puzzled" | "done";
}

/** It marks points for people, in place of those before; the robot does not see them. */
export interface MarkersCommand {
  do: "markers";
  /** where; [] = none [units] */
  points: [number, number, number][];
}

/** It adds the objects of a scene; all else stays as it is. */
export interface SpawnCommand {
  do: "spawn";
  /** a scene file (docs/scene-format.md) in the unit of the scene, which names no files and has none of the ids that were used before */
  xml: string;
}

/** It takes an object out of the world, without a hand; none may hold it. */
export interface RemoveCommand {
  do: "remove";
  /** id of a whole object */
  object: string;
}

/** It takes all objects out of the world but what is held, with what hangs on it. */
export interface ClearCommand {
  do: "clear";
}

/** It goes to another scene, at its start; undo leads back into the one that was left. */
export interface LoadCommand {
  do: "load";
  /** a scene file (docs/scene-format.md) that names no files; a script may have the name of a `file` in its place */
  xml: string;
}

/** It takes back the last action, with everything since. */
export interface UndoCommand {
  do: "undo";
}

/** It does what was undone last again, up to when it was undone. */
export interface RedoCommand {
  do: "redo";
}

/** It records from now on, into a new directory. */
export interface StartCommand {
  do: "start";
  /** of the directory; the scene's if not given */
  name?: string;
  /** of the recording */
  title?: string;
  /** about the recording */
  notes?: string;
}

/** It finishes the recording. */
export interface FinishCommand {
  do: "finish";
}

/** It carries the held object to where a ray meets the hand's plane; for scripts and pages only, it becomes a move_to. */
export interface DragCommand {
  do: "drag";
  /** which of the demonstrator's hands */
  hand: "left" | "right" | "both" | "any";
  /** where the ray begins [units] */
  origin: [number, number, number];
  /** of the ray, of any length but 0 */
  direction: [number, number, number];
  /** in a level plane instead; false if not given */
  level?: boolean;
  /** at most this fast; 10 if not given [units/s] */
  speed?: number;
}

/** It adds ready-made objects at a free place; becomes a spawn. */
export interface AddCommand {
  do: "add";
  /** big_block, stack_3, stack_5, stack_8, box, ball, prism, ring or dominoes */
  preset: string;
  /** same objects there and same seed: same place and colors */
  seed?: number;
}

export type Command =
  | GraspCommand
  | MoveToCommand
  | PlaneCommand
  | RotateCommand
  | ReleaseCommand
  | DestroyCommand
  | AttendCommand
  | PointCommand
  | TriggerCommand
  | FastenCommand
  | LoosenCommand
  | JointVelocitiesCommand
  | JointAnglesCommand
  | TurnCommand
  | GripperCommand
  | PoseCommand
  | TrajectoryCommand
  | RobotCommand
  | FaceCommand
  | MarkersCommand
  | SpawnCommand
  | RemoveCommand
  | ClearCommand
  | LoadCommand
  | UndoCommand
  | RedoCommand
  | StartCommand
  | FinishCommand
  | DragCommand
  | AddCommand;
