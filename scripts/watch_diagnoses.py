#!/usr/bin/python3
"""Prints one line per diagnosed episode: its outcome, the diagnosed event, the confidence, and the time from the last sample to the
diagnosis. Ends after a number of episodes with a summary. Exits with 1 if a diagnosis was wrong, 2 if the episodes did not come in
time."""

import argparse
import bisect
import collections
import statistics
import sys
import threading
import time

import rospy
from contact_shapelets.msg import Diagnosis, Episode
from geometry_msgs.msg import WrenchStamped
from std_msgs.msg import String

# [s] An outcome and a diagnosis that arrive within this time belong to one episode. Episodes are farther apart.
TOGETHER = 1.0


class DiagnosisWatch:
    """Joins the messages on the topics of one cell."""

    def __init__(self, unknown_outcomes):
        self._changed = threading.Condition()
        self._unknown_outcomes = unknown_outcomes
        self._stamps = []
        self._arrivals = []
        self._ends = {}
        self._diagnoses = collections.deque()
        self._outcomes = collections.deque()
        self.latencies = []
        self.right = 0
        self._subscribers = [
            rospy.Subscriber("wrench", WrenchStamped, self._on_wrench, queue_size=1000, tcp_nodelay=True),
            rospy.Subscriber("episode", Episode, self._on_episode, queue_size=100, tcp_nodelay=True),
            rospy.Subscriber("diagnosis", Diagnosis, self._on_diagnosis, queue_size=100, tcp_nodelay=True),
            rospy.Subscriber("outcome", String, self._on_outcome, queue_size=100, tcp_nodelay=True),
        ]

    def _on_wrench(self, message):
        with self._changed:
            self._arrivals.append(time.monotonic())
            self._stamps.append(message.header.stamp.to_sec())

    def _on_episode(self, message):
        with self._changed:
            last = (len(message.force) - 1) * message.sample_period
            self._ends[message.episode_id] = message.header.stamp.to_sec() + last
            self._changed.notify_all()

    def _on_diagnosis(self, message):
        if message.final:
            with self._changed:
                self._diagnoses.append((time.monotonic(), message))
                self._changed.notify_all()

    def _on_outcome(self, message):
        with self._changed:
            self._outcomes.append((time.monotonic(), message.data))
            self._changed.notify_all()

    def _latency(self, arrived, episode_id):
        """Returns the time [s] from the arrival of the episode's last sample to `arrived`. Each connection has its own thread, so
        this program may take the diagnosis before the sample; then it returns 0."""
        last = bisect.bisect_right(self._stamps, self._ends[episode_id] + 1e-6) - 1
        return max(0.0, arrived - self._arrivals[max(last, 0)])

    def _next_pair(self):
        """Takes the oldest outcome and its diagnosis. Drops outcomes and diagnoses that stand alone, such as those of a push
        before the nodes were up. Returns None if there is no complete pair yet."""
        while self._outcomes and self._diagnoses:
            (said, outcome), (arrived, diagnosis) = self._outcomes[0], self._diagnoses[0]
            if abs(said - arrived) < TOGETHER:
                if diagnosis.episode_id not in self._ends:
                    return None
                self._outcomes.popleft()
                self._diagnoses.popleft()
                return outcome, arrived, diagnosis
            (self._outcomes if said < arrived else self._diagnoses).popleft()
        return None

    def wait_for(self, index, deadline):
        """Waits for the next episode and prints its line with the number `index`. Returns False if none came."""
        with self._changed:
            pair = self._next_pair()
            while pair is None:
                if rospy.is_shutdown() or time.monotonic() > deadline:
                    return False
                self._changed.wait(0.2)
                pair = self._next_pair()
            outcome, arrived, diagnosis = pair
            self.latencies.append(1e3 * self._latency(arrived, diagnosis.episode_id))
            expected = "unknown" if outcome in self._unknown_outcomes else outcome
            self.right += diagnosis.event == expected
            print(f"{index:3d}  outcome {outcome:12s} diagnosed {diagnosis.event:12s} "
                  f"confidence {diagnosis.confidence:4.2f}  {self.latencies[-1]:5.1f} ms after the last sample", flush=True)
            return True


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--episodes", type=int, default=12, help="number of episodes to wait for")
    parser.add_argument("--timeout", type=float, default=120.0, help="seconds to wait for all of them")
    parser.add_argument("--unknown", nargs="*", default=[], help="outcomes for which the event 'unknown' is right")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("watch_diagnoses", anonymous=True, disable_signals=True)
    watch = DiagnosisWatch(set(arguments.unknown))
    deadline = time.monotonic() + arguments.timeout
    seen = 0
    while seen < arguments.episodes and watch.wait_for(seen + 1, deadline):
        seen += 1
    if seen:
        print(f"{watch.right} of {seen} diagnoses right; diagnosis {statistics.median(watch.latencies):.1f} ms (median) and "
              f"{max(watch.latencies):.1f} ms (longest) after the last sample")
    if seen < arguments.episodes:
        print(f"Only {seen} of {arguments.episodes} episodes came within {arguments.timeout:g} s", file=sys.stderr)
        return 2
    return 0 if watch.right == seen else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
