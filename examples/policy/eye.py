"""How a policy knows where objects are: rows of x, y, z [units] and yaw [rad], as in network.py."""

import numpy as np

import alike
import network
import sight

SURE = 0.3       # least probability of the cell of an object, below which it stays where it was seen last
APART = 4        # cells between the middles of two objects that look alike, at least
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

    def __init__(self, nets, looks, aux):
        if tuple(np.ravel(aux.cameraSize)) != sight.SIZE:
            height, width = sight.SIZE
            raise ValueError(f"this policy sees pictures of another size: use --size {width}x{height}")
        self.nets, self.looks, self.intrinsics = nets, looks, aux.cameraIntrinsics
        self.seen = None
        self.held = [None, None]  # of each arm: number of an object, and where it is from the tool
        aux.channels, aux.imageSeconds = ["rgb"], 0

    def objects(self, sensor, tools, is_deciding):
        if self.seen is None or is_deciding:
            found, chances = self.look(sensor.rgbVision / 255, sensor.cameraPose)
            self.seen = found if self.seen is None else self.updated(found, chances)
        for arm, tool in enumerate(tools):
            self.follow(arm, tool)
        return self.seen.copy()

    def look(self, picture, pose):
        """Returns all objects, and how sure it is of each; of those that look alike, the leftmost first."""
        cells, chances = self.find(picture)
        middles = sight.middles_of(np, cells)
        pieces = sight.pieces_of(picture, middles, sight.PIECE)
        said = sight.look(np, self.nets["look"], pieces, middles)
        pixels = middles + sight.SHIFT_SCALE * said[:, :2]
        places = sight.points_of(np, pixels, said[:, 2], pose, self.intrinsics)
        return np.column_stack([places, np.arctan2(said[:, 3], said[:, 4]) / 4]), chances

    def find(self, picture):
        """Returns the cells (N,) of all objects, and their probabilities."""
        scores = sight.find(np, self.nets["find"], sight.cells_of(picture))
        chances = np.exp(scores - scores.max(axis=0))
        chances /= chances.sum(axis=0)
        columns = sight.SIZE[1] // sight.CELL
        row, column = np.divmod(np.arange(len(chances)), columns)
        cells, best = np.zeros(len(self.looks), int), np.zeros(len(self.looks))
        for look in set(self.looks):
            # It sees only what is near a cell, so it says of none of those that look alike which of them it is. When one is
            # found, the others are where else it may be.
            group = np.flatnonzero(self.looks == look)
            rest, found = chances[:, group].mean(axis=1), []
            for _ in group:
                cell = int(rest.argmax())
                found.append((column[cell], cell, rest[cell] / rest.sum()))
                rest[np.maximum(abs(row - row[cell]), abs(column - column[cell])) < APART] = 0
            for k, (_, cell, chance) in zip(group, sorted(found)):
                cells[k], best[k] = cell, chance
        return cells, best

    def updated(self, found, chances):
        """What was seen before, with what is surely found now."""
        order = alike.order_as_before(self.looks, found, self.seen)
        found, is_sure = found[order], chances[order] > SURE
        return np.where(is_sure[:, None], found, self.seen)

    def follow(self, arm, tool):
        """Moves what an arm holds with its tool (5,)."""
        is_open = tool[4] >= network.HELD
        if self.held[arm] is None:
            if is_open:
                return
            away = np.linalg.norm(self.seen[:, :3] - tool[:3], axis=-1)
            if away.min() > NEAR:
                return
            self.held[arm] = int(away.argmin()), self.seen[away.argmin()] - tool[:4]
        number, offset = self.held[arm]
        self.seen[number] = tool[:4] + offset
        self.seen[number, 3] = network.upright(self.seen[number, 3])
        if is_open:
            # Here it was put down: the tool has moved since the last step.
            self.held[arm] = None
