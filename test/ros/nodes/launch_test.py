#!/usr/bin/python3
"""The shipped launch files load and start, and a signal ends a training cleanly."""

import contextlib
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import rosbag
import roslaunch.config
import roslib.packages
import rospkg
import rospy
import rostest
from contact_shapelets.msg import Diagnosis, EpisodeEvent
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import WrenchStamped
from std_msgs.msg import Bool

PACKAGE = "contact_shapelets"
ROOT = pathlib.Path(rospkg.RosPack().get_path(PACKAGE))
LIMIT = 60.0
END_LIMIT = 20.0  # roslaunch itself kills its nodes after 17 s
ARGUMENTS = {
    "record.launch": ["prefix:={folder}/recording"],
    "replay.launch": ["bag:={folder}/recording.bag", "model:={folder}/model.bag"],
    "demo.launch": [f"cell:={'true' if roslib.packages.find_node(PACKAGE, 'simulated_cell_node') else 'false'}"],
}
DRIVERS = {
    "iiwa_stack": "/iiwa/wrench",
    "iiwa_ros": "/iiwa/wrench",
    "kuka_iiwa_interface": "/victor/left_gripper/wrench",
    "franka_ros": "/franka_state_controller/F_ext",
    "force_torque_sensor_controller": "/ft_sensor",
}


@contextlib.contextmanager
def started(command, **options):
    """Starts a program, and kills it at the end if it still runs: Popen itself would wait for it without limit."""
    process = subprocess.Popen(command, start_new_session=True, **options)
    try:
        yield process
    finally:
        end(process)


def end(process):
    """Interrupts a program and its children. Returns its exit code, or None if it had to be killed."""
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
    try:
        return process.wait(END_LIMIT)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait(END_LIMIT)
        return None


def load(path, arguments=()):
    """Returns the configuration of a launch file as roslaunch sees it."""
    return roslaunch.config.load_config_default([(str(path), list(arguments))], None, verbose=False)


def remaps_of(config, node_type):
    """Returns the remapped topics of the node of this type, by their names in the node."""
    (node,) = [node for node in config.nodes if node.type == node_type]
    return {source.rsplit("/", 1)[-1]: target for source, target in node.remap_args}


class Health:
    """The last diagnostic status of each node, and its first with samples."""

    def __init__(self):
        self.last = {}
        self.first_with_samples = {}
        self.subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, self.take)

    def take(self, array):
        for status in array.status:
            node = status.name.split(":")[0]
            self.last[node] = status.message
            if any(entry.key == "samples" and int(entry.value) > 0 for entry in status.values):
                self.first_with_samples.setdefault(node, status.message)

    def wait_for(self, node, part):
        limit = time.monotonic() + LIMIT
        while part not in self.last.get(node, ""):
            if time.monotonic() > limit:
                return False
            time.sleep(0.02)
        return True


class LaunchFiles(unittest.TestCase):
    def test_each_loads_and_names_programs_that_exist(self):
        files = sorted((ROOT / "launch").rglob("*.launch"))
        self.assertGreaterEqual(len(files), 10)
        programs = set()
        for path in files:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                config = load(path, [argument.format(folder=folder) for argument in ARGUMENTS.get(path.name, [])])
                self.assertFalse(config.config_errors)
                self.assertTrue(config.nodes)
                programs.update((node.package, node.type) for node in config.nodes)
        for package, program in programs:
            self.assertTrue(roslib.packages.find_node(package, program), f"{package}/{program}")

    def test_each_driver_is_loaded_and_listens_to_the_drivers_topic(self):
        paths = {path.stem: path for path in (ROOT / "launch/drivers").glob("*.launch")}
        self.assertEqual(set(paths), set(DRIVERS))
        for name, topic in DRIVERS.items():
            with self.subTest(name):
                self.assertEqual(remaps_of(load(paths[name]), "episode_node")["wrench"], topic)
                told = load(paths[name], ["segmentation:=action", "action_status:=/push/status"])
                self.assertEqual(told.params["/episode_node/segmentation"].value, "action")
                self.assertEqual(remaps_of(told, "episode_node")["action_status"], "/push/status")

    def test_adapters_publish_what_the_episode_node_listens_to(self):
        for name, source in (("iiwa_stack", "/iiwa/state/CartesianWrench"), ("iiwa_ros", "/additional_outputs")):
            with self.subTest(name):
                config = load(ROOT / f"launch/drivers/{name}.launch")
                adapter = remaps_of(config, "wrench_adapter_node")
                self.assertEqual(adapter["driver_message"], source)
                self.assertEqual(adapter["wrench"], remaps_of(config, "episode_node")["wrench"])

    def test_values_of_the_config_hold_unless_an_argument_is_given(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as config:
            config.write("segmentation: contact\ncontact_on: 12.0\n")
            config.flush()
            path = ROOT / "launch/diagnose.launch"
            plain = load(path, [f"config:={config.name}"]).params
            told = load(path, [f"config:={config.name}", "segmentation:=action"]).params
        self.assertEqual(plain["/episode_node/segmentation"].value, "contact")
        self.assertEqual(plain["/episode_node/contact_on"].value, 12.0)
        self.assertEqual(told["/episode_node/segmentation"].value, "action")

    def test_episodes_are_cut_as_for_the_model_unless_a_config_is_given(self):
        path = ROOT / "launch/diagnose.launch"
        plain = load(path, ["model:=/data/switch.bag"]).params
        self.assertEqual(plain["/episode_node/preparation"].value, "/data/switch.bag")
        self.assertNotIn("/episode_node/segmentation", plain)
        told = load(path, ["model:=/data/switch.bag", f"config:={ROOT}/config/episode.yaml"]).params
        self.assertNotIn("/episode_node/preparation", told)
        self.assertEqual(told["/episode_node/segmentation"].value, "trigger")

    def test_recorded_pushes_are_diagnosed_without_further_subscribers(self):
        events = []
        subscriber = rospy.Subscriber("/event", rospy.AnyMsg, events.append)
        command = ["roslaunch", "--wait", PACKAGE, "demo.launch", "cell:=false", "speed:=20"]
        try:
            with started(command):
                limit = time.monotonic() + LIMIT
                while not events and time.monotonic() < limit:
                    time.sleep(0.02)
        finally:
            rospy.delete_param("/use_sim_time")
        subscriber.unregister()
        self.assertTrue(events)

    def test_diagnose_starts_and_ends(self):
        health = Health()
        command = ["roslaunch", "--wait", PACKAGE, "diagnose.launch", "model:=" + rospy.get_param("/paths/model")]
        with started(command) as process:
            self.assertTrue(health.wait_for("classifier_node", "model in use"), health.last)
            self.assertTrue(health.wait_for("episode_node", "wrench yet"), health.last)
            self.assertEqual(end(process), 0)


class Pushes:
    """A sensor at 200 Hz, a sequencer, and the diagnoses of its pushes."""

    def __init__(self):
        self.diagnoses = []
        self.wrench = rospy.Publisher("/wrench", WrenchStamped, queue_size=1000)
        self.active = rospy.Publisher("/episode_active", Bool, queue_size=10)
        self.subscriber = rospy.Subscriber("/diagnosis", Diagnosis, self.take)

    def take(self, diagnosis):
        if diagnosis.final:
            self.diagnoses.append(diagnosis.episode_id)

    def wait_for_subscribers(self):
        limit = time.monotonic() + LIMIT
        while not (self.wrench.get_num_connections() and self.active.get_num_connections()):
            if time.monotonic() > limit:
                return False
            time.sleep(0.02)
        return True

    def sense(self, duration, force):
        for step in range(int(200 * duration)):
            wrench = WrenchStamped()
            wrench.header.stamp = rospy.Time.now()
            wrench.wrench.force.z = force * math.sin(math.pi * step / (200 * duration)) + 1e-3 * (step % 2)
            self.wrench.publish(wrench)
            time.sleep(0.005)

    def push(self):
        """Returns whether one push is diagnosed."""
        before = len(self.diagnoses)
        self.sense(0.3, 0.0)
        self.active.publish(True)
        self.sense(0.6, 20.0)
        self.active.publish(False)
        limit = time.monotonic() + LIMIT / 4
        while len(self.diagnoses) == before and time.monotonic() < limit:
            self.sense(0.1, 0.0)
        return len(self.diagnoses) == before + 1


class Launched:
    """A launch file of the package that runs, and what it prints."""

    def __init__(self, *arguments):
        command = ["roslaunch", "--wait", PACKAGE, *arguments]
        self.process = subprocess.Popen(command, start_new_session=True, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True)
        self.lines = []
        threading.Thread(target=lambda: self.lines.extend(self.process.stdout), daemon=True).start()

    def wait_for(self, part):
        limit = time.monotonic() + LIMIT
        while not any(part in line for line in list(self.lines)):
            if time.monotonic() > limit:
                return False
            time.sleep(0.02)
        return True

    def end(self):
        return end(self.process)


class Recording(unittest.TestCase):
    def test_ends_if_the_recorder_cannot_write(self):
        with started(["roslaunch", "--wait", PACKAGE, "record.launch", "prefix:=/no/such/folder/day"]) as process:
            process.wait(LIMIT)


class RecordingBesideDiagnosing(unittest.TestCase):
    def test_each_push_is_diagnosed_and_one_takes_over_from_the_other(self):
        pushes = Pushes()
        with tempfile.TemporaryDirectory() as folder:
            record = Launched("record.launch", f"prefix:={folder}/day")
            try:
                self.assertTrue(pushes.wait_for_subscribers())
                diagnose = Launched("diagnose.launch", "model:=" + rospy.get_param("/paths/model"))
                try:
                    self.assertTrue(diagnose.wait_for("/episode_node runs already"), diagnose.lines)
                    self.assertEqual([pushes.push() for _ in range(5)], [True] * 5, diagnose.lines)
                    record.end()
                    self.assertTrue(diagnose.wait_for("/episode_node takes over"), diagnose.lines)
                    self.assertTrue(pushes.wait_for_subscribers())
                    self.assertTrue(pushes.push(), diagnose.lines)
                finally:
                    diagnose.end()
            finally:
                record.end()
            (recording,) = pathlib.Path(folder).glob("day*.bag")
            with rosbag.Bag(str(recording)) as bag:
                opened = [message.kind for _, message, _ in bag.read_messages("episode_event")]
            self.assertEqual(opened, [EpisodeEvent.OPEN, EpisodeEvent.CLOSE] * 5)


class Diagnostics(unittest.TestCase):
    def test_the_first_status_with_samples_does_not_miss_them(self):
        health = Health()
        publisher = rospy.Publisher("/fresh/wrench", WrenchStamped, queue_size=100)
        (program,) = roslib.packages.find_node(PACKAGE, "episode_node")[:1]
        wrench = WrenchStamped()
        with started([program, "__ns:=/fresh", "__name:=episode_node"]):
            limit = time.monotonic() + LIMIT
            while not health.first_with_samples and time.monotonic() < limit:
                wrench.header.stamp = rospy.Time.now()
                wrench.wrench.force.z += 0.001
                publisher.publish(wrench)
                time.sleep(0.005)
        (message,) = health.first_with_samples.values()
        self.assertNotIn("no usable sample", message)


class Training(unittest.TestCase):
    def end_by(self, number, name):
        (program,) = roslib.packages.find_node(PACKAGE, "trainer_node")[:1]
        with tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder) / "model.bag"
            shutil.copy(rospy.get_param("/paths/model"), output)
            before = output.read_bytes()
            health = Health()
            command = [program, f"__name:={name}", "_steps:=1000000", f"_output:={output}",
                       f"_bags:={ROOT}/bags/switch_push_test.bag"]
            with started(command) as process:
                self.assertTrue(health.wait_for(name, "training"), health.last)
                process.send_signal(number)
                self.assertEqual(process.wait(LIMIT), 0)
            self.assertEqual(output.read_bytes(), before)
            self.assertEqual(os.listdir(folder), ["model.bag"])

    def test_ends_by_interrupt_and_leaves_the_old_model(self):
        self.end_by(signal.SIGINT, "interrupted")

    def test_ends_by_termination_and_leaves_the_old_model(self):
        self.end_by(signal.SIGTERM, "terminated")


if __name__ == "__main__":
    rospy.init_node("launch_test")
    rostest.rosrun(PACKAGE, "launch_test", "launch_test")
