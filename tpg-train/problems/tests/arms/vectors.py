"""Forward kinematics of an arm's own URDF, as the table that `../arms.rs` compares this project's kinematics with.

    python3 vectors.py FILE TIP JOINT... > NAME.csv

FILE is a URDF, or a xacro whose numbers are plain or in `pi`, `radians()` and its own numeric properties. Every joint between its
root and the link TIP that is not named stays at 0. A row: the angles of the named joints, 4096 a turn, and the place of the tip, mm,
from the point of the first named joint's axis at the height of the root link; x, y, z as in the file. 120 poses, uniform within the
limits.

The committed tables come from these files; limits of a turn are 0.00001 rad short of it:

| table | file | tip | joints |
| --- | --- | --- | --- |
| px100 | Interbotix/interbotix_ros_manipulators 0bb2b0e, interbotix_xsarm_descriptions/urdf/px100.urdf.xacro (BSD-3-Clause) |
  $(arg robot_name)/ee_gripper_link | waist shoulder elbow wrist_angle |
| open-manipulator-x | ROBOTIS-GIT/open_manipulator 3fd6fa9, open_manipulator_description/urdf/open_manipulator_x/
  open_manipulator_x_arm.urdf.xacro (Apache-2.0) | end_effector_link | joint1 joint2 joint3 joint4 |
| so101 | TheRobotStudio/SO-ARM100 fda892c, Simulation/SO101/so101_new_calib.urdf (Apache-2.0) | gripper_frame_link | shoulder_pan
  shoulder_lift elbow_flex wrist_flex |
"""

import math
import random
import re
import sys
import xml.etree.ElementTree as ElementTree


TICKS = 4096 / math.tau


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def turned(axis, angle):
    """Rodrigues' formula."""
    x, y, z = (value / math.hypot(*axis) for value in axis)
    c, s = math.cos(angle), math.sin(angle)
    t = 1 - c
    return [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0],
        [0, 0, 0, 1],
    ]


def moved(xyz):
    return [[float(i == j) if j < 3 else xyz[i] if i < 3 else 1.0 for j in range(4)] for i in range(4)]


def origin(xyz, rpy):
    roll, pitch, yaw = rpy
    turn = product(product(turned([0, 0, 1], yaw), turned([0, 1, 0], pitch)), turned([1, 0, 0], roll))
    return product(moved(xyz), turn)


def read(file):
    root = ElementTree.parse(file).getroot()
    names = {"pi": math.pi, "radians": math.radians, "prefix": ""}

    def value(text):
        return re.sub(r"\$\{([^}]*)\}", lambda found: str(eval(found[1], {"__builtins__": {}}, names)), text)

    for element in root.iter():
        if element.tag.endswith("}property"):
            try:
                names[element.get("name")] = float(value(element.get("value")))
            except ValueError:
                pass

    def numbers(element, attribute):
        text = "0 0 0" if element is None else element.get(attribute, "0 0 0")
        return [float(number) for number in value(text).split()]

    joints = {}
    for joint in root.iter("joint"):
        if joint.find("child") is None:
            continue
        limit, at = joint.find("limit"), joint.find("origin")
        joints[value(joint.find("child").get("link"))] = {
            "name": value(joint.get("name")),
            "parent": value(joint.find("parent").get("link")),
            "origin": origin(numbers(at, "xyz"), numbers(at, "rpy")),
            "axis": numbers(joint.find("axis"), "xyz") if joint.find("axis") is not None else [1.0, 0.0, 0.0],
            "range": None if limit is None or limit.get("lower") is None else [float(value(limit.get(end))) for end in ("lower", "upper")],
        }
    return joints


def chain(joints, tip):
    found = []
    while tip in joints:
        found.insert(0, joints[tip])
        tip = joints[tip]["parent"]
    return found


def place(joints, angles):
    """The frame of the tip, and of the first joint that turns."""
    frame, first = moved([0, 0, 0]), None
    for joint in joints:
        frame = product(frame, joint["origin"])
        if joint["name"] in angles:
            first = first or frame
            frame = product(frame, turned(joint["axis"], angles[joint["name"]]))
    return frame, first


def main(file, tip, *names):
    joints = [joint for joint in chain(read(file), tip) if joint["name"] != "fixed"]
    ranges = {joint["name"]: joint["range"] for joint in joints}
    source = random.Random(1)
    print(",".join(names) + ",x,y,z")
    for _ in range(120):
        ticks = {name: int(source.uniform(*ranges[name]) * TICKS) for name in names}
        frame, first = place(joints, {name: ticks[name] / TICKS for name in names})
        tip = [1000 * (frame[0][3] - first[0][3]), 1000 * (frame[1][3] - first[1][3]), 1000 * frame[2][3]]
        print(",".join([str(ticks[name]) for name in names] + [f"{value:.5f}" for value in tip]))


main(*sys.argv[1:])
