"""Tests `smile ros board`, `touch` and `calibrate`: known poses are found again, and bad measurements refused.

OpenCV draws the pictures of the board. Skipped without it (tools/get_ros.sh).

Usage: calibration_test.py PROJECT_FOLDER [TEST...], with the program in SMILE.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import cv2
except ImportError as error:
    print(f"skipped: {error}; tools/get_ros.sh installs OpenCV")
    sys.exit(77)

import numpy as np
import smile
from smile.ros.calibrating import calibrate, touch
from smile.ros.calibration import Board, plane_of, pose_of_touched, table_fault
from smile.ros.description import RobotDescription
from smile.ros.link import Reading

PROJECT, PROGRAM = Path(sys.argv[1]), os.environ["SMILE"]
GOLDEN = PROJECT / "tests/golden/recordings/imitation"
K = np.array([[600.0, 0, 330], [0, 610, 235], [0, 0, 1]])
D = np.array([-0.12, 0.05, 0.001, -0.0005, 0])
SIZE = (640, 480)
BOARD = Board()
NOISE = 0.0005
"""standard deviation of touched points [m]"""


def pose(turn, place):
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = cv2.Rodrigues(np.array(turn, float))[0], place
    return X


def picture(X_CP, noise=2.0):
    """The board in a camera: each pixel looks along its ray, averaged over 3 x 3 rays."""
    fine = 3
    x, y = np.meshgrid((np.arange(SIZE[0] * fine) + 0.5) / fine - 0.5, (np.arange(SIZE[1] * fine) + 0.5) / fine - 0.5)
    rays = cv2.undistortPoints(np.stack([x.ravel(), y.ravel()], axis=1)[:, None], K, D)[:, 0]
    # Where the ray meets z = 0 of the board.
    X_PC = np.linalg.inv(X_CP)
    along = np.column_stack([rays, np.ones(len(rays))]) @ X_PC[:3, :3].T
    hit = X_PC[:3, 3] - along * (X_PC[2, 3] / along[:, 2])[:, None]
    square = np.floor(hit[:, :2] / BOARD.square).astype(int) + 1
    on_board = (square >= 0).all(axis=1) & (square[:, 0] <= BOARD.columns) & (square[:, 1] <= BOARD.rows)
    black = on_board & (square.sum(axis=1) % 2 == 0)
    gray = np.where(black, 20.0, 220.0).reshape(SIZE[1], fine, SIZE[0], fine).mean(axis=(1, 3))
    gray += np.random.default_rng(1).normal(0, noise, gray.shape)
    return np.clip(gray, 0, 255).astype(np.uint8)


class CalibrationTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.description = RobotDescription(smile.open(GOLDEN))
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)

    def in_base(self, points, random=None):
        X_BW = np.linalg.inv(self.description.X_WB)
        points = np.asarray(points) @ X_BW[:3, :3].T + X_BW[:3, 3]
        return (points if random is None else points + random.normal(0, NOISE, points.shape)).tolist()

    def measurements(self, X_WP, X_WC, random, height=0.0):
        corners = BOARD.outermost() @ X_WP[:3, :3].T + X_WP[:3, 3]
        cv2.imwrite(str(self.folder / "board.png"), picture(np.linalg.inv(X_WC) @ X_WP))
        table = [[x, y, height] for x in (-0.5, 0, 0.5) for y in (-0.4, 0.3)]
        return {"table": self.in_base(table, random), "board": self.in_base(corners, random), "camera": {
            "name": "eye", "image": "board.png", "K": K.ravel().tolist(), "D": D.tolist()}}

    def test_cameras_at_known_poses_are_found(self):
        random = np.random.default_rng(7)
        # The board lies on the table: z of P goes down. It is seen from each side, also upside down.
        X_WP = pose([0, 0, 0.4], [0.1, 0.2, 0]) @ pose([np.pi, 0, 0], [0, 0, 0])
        middle = X_WP @ [BOARD.square * 4, BOARD.square * 2.5, 0, 1]
        for bearing in np.arange(0, 2 * np.pi, np.pi / 3):
            back = np.array([np.sin(bearing) * 0.35, -np.cos(bearing) * 0.35, 0.45])
            z = -back / np.linalg.norm(back)
            x = np.cross(z, [0, 0, 1])
            X_WC = np.eye(4)
            X_WC[:3, :3] = np.column_stack([x / np.linalg.norm(x), np.cross(z, x / np.linalg.norm(x)), z])
            X_WC[:3, 3] = middle[:3] + back
            cell = calibrate(self.measurements(X_WP, X_WC, random), self.description, self.folder)
            error = np.linalg.inv(X_WC) @ np.array(cell["camera"]["pose"])
            # The camera swings about the board, whose corners 0.2 m apart were touched with an error of 0.5 mm.
            self.assertLess(np.linalg.norm(error[:3, 3]), 0.006)
            self.assertLess(np.linalg.norm(cv2.Rodrigues(error[:3, :3])[0]), 0.01)
            self.assertLess(cell["camera"]["residual_px"], 0.3)
            self.assertLess(abs(cell["table"]["middle"][2]), 0.001)
            self.assertLess(cell["table"]["tilt"], 0.003)

    def test_faulty_pictures_and_measurements_are_refused(self):
        random = np.random.default_rng(3)
        X_WP = pose([np.pi, 0, 0], [0, 0, 0])
        # Far away and from straight above, where both tilts look alike.
        far = pose([np.pi, 0, 0], [0.1, -0.06, 2.0])
        good = self.measurements(X_WP, pose([np.pi + 0.5, 0, 0], [0.1, -0.36, 0.55]), random)

        def with_camera(**members):
            return {**good, "camera": {**good["camera"], **members}}

        calibrate(good, self.description, self.folder)
        (self.folder / "text.png").write_text("no picture")
        cv2.imwrite(str(self.folder / "gray.png"), np.full((480, 640), 128, np.uint8))
        for words, measured in (
                ("text.png: is not a picture", with_camera(image="text.png")),
                ("no board with 9 x 6 inner corners", with_camera(image="gray.png")),
                ("camera.K: expected 9 finite numbers", with_camera(K=[1, 2])),
                ("camera.K: expected focal lengths above 0", with_camera(K=[0] * 9)),
                (r"corners of the board are \d+\.\d+ px from where they should be", with_camera(K=[200, 0, 320, 0, 900, 240, 0, 0, 1])),
                ("camera.D is 'much', expected list", with_camera(D="much")),
                ("member 'shelf' is unknown", {**good, "shelf": []}),
                ("board: has 3 points, expected 4", {**good, "board": good["board"][:3]}),
                (r"touched corners of the board are \d+\.\d mm from where", {**good, "board": [good["board"][i] for i in (0, 2, 1, 3)]}),
                ("board: expected a list of points", {**good, "board": [[1, 2, float("nan")]] * 4}),
                ("one of them even and the other odd", {**good, "pattern": {"columns": 9, "rows": 7}}),
                ("table: has 3 points, expected 4", {**good, "table": good["table"][:3]}),
                ("there is no camera that saw it", {"table": good["table"], "board": good["board"]})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                calibrate(measured, self.description, self.folder)
        with self.assertRaisesRegex(ValueError, "could as well be tilted the other way"):
            calibrate(self.measurements(X_WP, far, random), self.description, self.folder)

    def test_points_near_a_line_or_not_on_a_plane_are_refused(self):
        line = np.array([[x, 0.02 * (i % 2), 0] for i, x in enumerate(np.linspace(0, 1, 8))])
        with self.assertRaisesRegex(ValueError, r"near a line: \d+ mm from it .* expected at least 50 mm"):
            plane_of(line)
        hills = np.array([[x, y, 0.02 * (x == y)] for x in (0, 1) for y in (0, 1)], float)
        with self.assertRaisesRegex(ValueError, "points on the table are 10.0 mm from a plane"):
            plane_of(hills)

    def test_a_tilted_table_has_its_height_everywhere(self):
        points = np.array([[x, y, 0.1 + 0.02 * x - 0.03 * y] for x in (-1, 0, 1) for y in (-1, 1)])
        plane = plane_of(points)
        self.assertAlmostEqual(plane.height(0.7, -0.2), 0.1 + 0.014 + 0.006, places=9)
        self.assertAlmostEqual(plane.tilt, np.arctan(np.hypot(0.02, 0.03)), places=9)

    def test_the_touched_board_has_its_pose(self):
        random = np.random.default_rng(5)
        for _ in range(50):
            X = pose(random.normal(size=3), random.normal(size=3))
            found, residual = pose_of_touched(BOARD, BOARD.outermost() @ X[:3, :3].T + X[:3, 3])
            np.testing.assert_allclose(found, X, atol=1e-9)
            self.assertLess(residual, 1e-9)

    def test_a_table_at_another_height_is_refused(self):
        for height, words in ((0.0, "None"), (0.004, "None"), (0.02, "the real table is 2[01] mm higher"), (-0.03, "mm lower")):
            table = self.in_base([[x, y, height] for x in (-0.5, 0.5) for y in (-0.4, 0.4)])
            cell = calibrate({"table": table}, self.description, self.folder)
            self.assertRegex(str(table_fault(cell, "baxter", (2, 1.2))), words)
        self.assertRegex(str(table_fault(cell, "tern", (2, 1.2))), "robot 'baxter', expected 'tern'")
        for damaged in ({}, {**cell, "format": 2}, {**cell, "table": {}}, {**cell, "table": {**cell["table"], "normal": [1, 0, 0]}}):
            with self.assertRaises(ValueError):
                table_fault(damaged, "baxter", (2, 1.2))

    def test_touched_places_are_those_of_the_tool(self):
        joints = [name for names in self.description.arms.values() for name in names]
        q = np.linspace(-0.5, 0.5, 7) + [0, 0, 0, 0.8, 0, 0, 0]
        time, moving = 0.0, False

        class Link:
            def wait(self, timeout):
                nonlocal time
                time += 1 / 60
                return Reading(time, 0, {**dict.fromkeys(joints, 0.0), **dict(zip(
                    self_description.arms["right"], q + (time if moving else 0)))})

        self_description, said = self.description, []

        def lines():
            nonlocal moving
            yield from ("t\n", "b\n", "x\n")
            moving = True
            yield "t\n"

        points = touch(Link(), self.description, "right", lines(), said.append)
        place = self.description.motion.forward("right", q)[:3, 3]
        np.testing.assert_allclose([points["table"], points["board"]], [[place], [place]], atol=1e-6)
        self.assertRegex(said[2], "'x': expected t")
        self.assertEqual(said[3], "not taken: the right arm moves")

    def test_the_board_is_to_scale(self):
        out = self.folder / "board.svg"
        subprocess.run([PROGRAM, "ros", "board", "--square", "0.03", "--out", out], check=True)
        text = out.read_text()
        self.assertIn('width="320mm" height="238mm" viewBox="0 0 320 238"', text)
        squares = {(float(x), float(y)) for x, y in re.findall(r'<rect x="(\S+)" y="(\S+)" width="30" height="30"/>', text)}
        self.assertEqual(squares, {(10 + 30 * x, 10 + 30 * y) for x in range(10) for y in range(7) if (x + y) % 2 == 0})

    def test_the_programs_work_together(self):
        measured, cell = self.folder / "measured.json", self.folder / "cell.json"
        for height, code in ((0.0, 2), (0.05, 1)):
            measured.write_text(json.dumps({"table": self.in_base(
                [[x, y, height] for x in (-0.5, 0.5) for y in (-0.4, 0.4)])}))
            done = subprocess.run([PROGRAM, "ros", "calibrate", GOLDEN, measured, "--out", cell], check=True, capture_output=True, text=True)
            self.assertRegex(done.stdout, rf"^table: \+{1000 * height:.1f} mm from the scene's at the middle of 4 points, tilted by 0\.00°")
            # Neither reaches a robot: the good one finds no server, and the other is refused before.
            done = subprocess.run([PROGRAM, "ros", "perform", GOLDEN, "--cell", cell, "--dry-run", "--bridge", "ws://127.0.0.1:9"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertRegex(done.stdout, "refused: the real table is 50 mm higher at a corner than that of the scene")
        measured.write_text("[1, 2")
        done = subprocess.run([PROGRAM, "ros", "calibrate", GOLDEN, measured, "--out", cell], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "error: .*measured.json: .*is not JSON")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
