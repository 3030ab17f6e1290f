"""The agents to compare the learner with, in python/examples/agents, do what they are for, and what they
claim is right.

    agents_test.py SMILE SOURCE

SMILE is the program, SOURCE the folder of the project.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

# Agent, scene of the tower, seed of its layout, whether it succeeds. The demonstrator's scene is the one in
# which everything is where it was in the demonstration.
SHOWN, OTHER = "tower.xml", "tower_robot.xml"
CASES = [("idle", OTHER, 1, False), ("replay", SHOWN, None, True), ("replay", OTHER, 1, False),
         ("relative_replay", OTHER, 1, True), ("without_depth", OTHER, 1, True),
         ("without_second_look", OTHER, 1, True), ("oracle", OTHER, 1, True), ("true_poses", OTHER, 1, True)]
MAX_LINES = 200


def main(smile, source):
    agents = Path(source) / "python/examples/agents"
    for file in agents.glob("*.py"):
        assert len(file.read_text().splitlines()) < MAX_LINES, file
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([smile, "run", f"{source}/scenes/tower.xml", "--kinematic", "--commands",
                        f"{source}/examples/tower.jsonl", "--record", "shown"], check=True,
                       stdout=subprocess.DEVNULL)
        for k, (agent, scene, seed, succeeds) in enumerate(CASES):
            layout = (["--seed", str(seed)] if seed else []) + (["--oracle"] if agent in ("oracle", "true_poses") else [])
            run = subprocess.run([smile, "imitate", "shown", f"{source}/scenes/{scene}", "--brain",
                                  agents / f"{agent}.py", "--no-pictures", "--timeout", "60", "--out",
                                  f"done{k}", *layout], stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True)
            result = json.loads(Path(f"done{k}/result.json").read_text())
            assert result["success"] == succeeds, f"{agent} in {scene}: {run.stdout}"
            claim = result["brain"]["claim"]["done"]
            assert claim == succeeds and result["claim_right"], f"{agent} in {scene}: {run.stdout}"
            assert agent != "idle" or result["gain"] == 0
            print(agent, scene, *layout)


main(*sys.argv[1:])
