"""How a policy knows where objects are: rows of x, y, z [units] and yaw [rad], as in network.py."""

import numpy as np

import network
import sight

SURE = 0.3       # least probability of the cell of an object, below which it stays where it was seen last
NEAR = 0.8       # distance from the tool of what a closed gripper holds, at most [units]


class Told:
    """True poses (`--oracle`), which a real robot does not have."""

    def __init__(self, names, aux):
        if "objectNames" not in aux:
            raise ValueError("this policy needs the poses of all objects: use --oracle")
        known = aux.objectNames.split("\n")
        self.order = [known.index(name) for name in names]
        aux.channels = []

    def objects(self, sensor, tools, is_deciding):
        return np.array([[*pose[:3, 3], network.yaw_of_object(pose[:3, :3])]
                         for pose in np.moveaxis(sensor.objectPoses[:, :, self.order], 2, 0)])


class Eye:
    """Pictures of the robot's eye, at which it looks when it decides; what it holds goes with the tool."""

    def __init__(self, nets, aux):
        if tuple(np.ravel(aux.cameraSize)) != sight.SIZE:
            height, width = sight.SIZE
            raise ValueError(f"this policy sees pictures of another size: use --size {width}x{height}")
        self.nets, self.intrinsics = nets, aux.cameraIntrinsics
        self.seen = None
        self.held = [None, None]  # of each arm: number of an object, and where it is from the tool
        aux.channels, aux.imageSeconds = ["rgb"], 0

    def objects(self, sensor, tools, is_deciding):
        if self.seen is None or is_deciding:
            found, is_sure = self.look(sensor.rgbVision / 255, sensor.cameraPose)
            self.seen = found if self.seen is None else np.where(is_sure[:, None], found, self.seen)
        for arm, tool in enumerate(tools):
            self.follow(arm, tool)
        return self.seen.copy()

    def look(self, picture, pose):
        """Returns all objects, and which of them are surely where they seem to be."""
        scores = sight.find(np, self.nets["find"], sight.cells_of(picture))
        chances = np.exp(scores - scores.max(axis=0))
        is_sure = chances.max(axis=0) / chances.sum(axis=0) > SURE
        middles = sight.middles_of(np, scores.argmax(axis=0))
        pieces = sight.pieces_of(picture, middles, sight.PIECE)
        said = sight.look(np, self.nets["look"], pieces, middles)
        pixels = middles + sight.SHIFT_SCALE * said[:, :2]
        places = sight.points_of(np, pixels, said[:, 2], pose, self.intrinsics)
        return np.column_stack([places, np.arctan2(said[:, 3], said[:, 4]) / 4]), is_sure

    def follow(self, arm, tool):
        """Moves what an arm holds with its tool (5,)."""
        if tool[4] >= network.HELD:
            self.held[arm] = None
            return
        if self.held[arm] is None:
            away = np.linalg.norm(self.seen[:, :3] - tool[:3], axis=-1)
            if away.min() > NEAR:
                return
            self.held[arm] = int(away.argmin()), self.seen[away.argmin()] - tool[:4]
        number, offset = self.held[arm]
        self.seen[number] = tool[:4] + offset
        self.seen[number, 3] = network.upright(self.seen[number, 3])
