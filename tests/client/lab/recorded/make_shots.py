"""Makes made_up_shots.json: four shots of our own simulation on a carom table, as a camera would have recorded them.

    python3 make_shots.py POOLHALL_LAB > made_up_shots.json

50 places a second, off by up to 0.3 mm, rounded to a millimetre, without those nearer than 2 mm to the last."""

import json
import math
import random
import subprocess
import sys

LENGTH, WIDTH, RADIUS = 2.84, 1.42, 0.03075
SHOTS = [  # places of three balls, the cue ball first; where it aims; speed; tip
    ([(-0.9, -0.3), (0.7, 0.25), (1.0, -0.4)], (0.7, 0.22), 3.2, [-0.25, 0.2]),
    ([(0.6, 0.4), (-0.3, 0.1), (-1.1, -0.5)], (-0.3, 0.13), 2.6, [0.3, 0.1]),
    ([(-0.2, 0.5), (0.9, 0.3), (-0.8, 0.2)], (0.9, 0.27), 3.8, [0.2, -0.1]),
    ([(1.1, -0.2), (0.1, -0.45), (-0.9, 0.4)], (0.1, -0.43), 3.0, [-0.3, 0.3]),
]


def scene(balls, aim, speed, offset):
    cue = balls[0]
    return {
        "schema": "poolhall.scene/1",
        "table": {"length": LENGTH, "width": WIDTH},
        "ball": {"radius": RADIUS, "mass": 0.21},
        "effects": {"sliding": {"mu": 0.2}, "rolling": {"mu": 0.0045}, "spin_decay": {"mu": 0.006},
                    "ball_ball": {"model": "friction", "e": 0.96, "mu": 0.06},
                    "rail": {"model": "han2005", "e": 0.86, "mu": 0.25, "nose_height": 0.0369}},
        "solver": {"kind": "event"},
        "balls": [{"id": str(number + 1), "r": list(place)} for number, place in enumerate(balls)],
        "strike": {"ball": "1", "direction": [aim[0] - cue[0], aim[1] - cue[1]], "speed": speed, "offset": offset},
    }


def recorded(samples, hz, noise):
    """The places of one ball as the camera's file has them."""
    track = {"t": [], "x": [], "y": []}
    for number, place in enumerate(samples):
        x, y = (round(value + noise.uniform(-3e-4, 3e-4), 3) for value in place[:2])
        last = number == len(samples) - 1
        far = not track["t"] or math.hypot(x - track["x"][-1], y - track["y"][-1]) >= 0.002
        if far or last:
            track["t"].append(round(number / hz, 3))
            track["x"].append(x)
            track["y"].append(y)
    return track


def main(lab):
    lines = "\n".join(json.dumps(scene(*shot)) for shot in SHOTS)
    answer = subprocess.run([lab, "simulate", "--sample", "50", "-"], input=lines, capture_output=True, text=True, check=True)
    noise = random.Random(1)
    shots = []
    for number, line in enumerate(answer.stdout.splitlines()):
        samples = [sample["r"] for sample in json.loads(line)["samples"]]
        balls = {str(ball + 1): recorded([places[ball] for places in samples], 50, noise) for ball in range(3)}
        shots.append({"id": number + 1, "balls": balls})
    print("[" + ",\n".join(json.dumps(shot, separators=(",", ":")) for shot in shots) + "]")


if __name__ == "__main__":
    main(sys.argv[1])
