"""Reads episodes, models and diagnoses of contact_shapelets into NumPy arrays.

    import contact_shapelets
    episodes = contact_shapelets.read_episodes("monday.bag")
    model = contact_shapelets.read_model("switch.bag")
    table = contact_shapelets.table(episodes)        # a pandas.DataFrame
"""

import dataclasses

import numpy as np
import rosbag


@dataclasses.dataclass
class Episode:
    """The magnitude of the contact force over one episode, and what was made of it."""

    id: str
    start: float  # [s] since the epoch
    sample_period: float  # [s]
    force: np.ndarray  # [Q] in N, after tare
    complete: bool
    outcome: str  # as the operator gave it; may be empty
    event: str = ""  # the final diagnosis, if the bag holds one
    confidence: float = np.nan
    novelty: float = np.nan

    @property
    def time(self):
        """Time of each sample [s] from the start of the episode, [Q]."""
        return self.sample_period * np.arange(len(self.force))

    @property
    def duration(self):
        """Duration [s]."""
        return self.sample_period * len(self.force)


@dataclasses.dataclass
class Cluster:
    """One cluster of a model."""

    name: str  # empty if it has none
    size: int  # number of training episodes
    centroid: np.ndarray  # [K]


@dataclasses.dataclass
class Model:
    """Shapelets and clusters of a model file."""

    id: str
    sample_period: float  # [s]
    shapelets: list  # [K] arrays of z-normalised values
    dilations: np.ndarray  # [K] samples of the episode between two values of a shapelet
    clusters: list
    message: object  # the whole contact_shapelets/ShapeletModel


def _last_part(topic):
    return topic.rsplit("/", 1)[-1]


def read_episodes(path):
    """Returns the Episode messages of a bag in their order, with outcomes and final diagnoses where the bag has them.

    Raises ValueError if the bag holds no Episode message. A bag of raw wrench must be cut first, by episode_node or by
    replay.launch with a recorder.
    """
    episodes, finals = [], {}
    with rosbag.Bag(path) as bag:
        for topic, message, _ in bag.read_messages():
            if message._type == "contact_shapelets/Episode" and _last_part(topic) == "episode":
                episodes.append(
                    Episode(
                        message.episode_id,
                        message.header.stamp.to_sec(),
                        message.sample_period,
                        np.array(message.force, dtype=np.float32),
                        message.complete,
                        message.outcome,
                    )
                )
            elif message._type == "contact_shapelets/Diagnosis" and message.final:
                finals[(message.episode_id, message.header.stamp.to_sec())] = message
            elif message._type == "std_msgs/String" and _last_part(topic) == "outcome" and episodes:
                episodes[-1].outcome = episodes[-1].outcome or message.data
    if not episodes:
        raise ValueError(f"{path}: expected contact_shapelets/Episode messages, but found none")
    for episode in episodes:
        diagnosis = finals.get((episode.id, episode.start))
        if diagnosis is not None:
            episode.event, episode.confidence, episode.novelty = (
                diagnosis.event,
                diagnosis.confidence,
                diagnosis.novelty,
            )
    return episodes


def read_model(path):
    """Returns the model of a file that `shapelets train` or trainer_node wrote.

    Raises ValueError if the file does not hold exactly one model.
    """
    with rosbag.Bag(path) as bag:
        messages = [message for _, message, _ in bag.read_messages() if message._type == "contact_shapelets/ShapeletModel"]
    if len(messages) != 1:
        raise ValueError(f"{path}: expected one contact_shapelets/ShapeletModel, but found {len(messages)}")
    message = messages[0]
    return Model(
        message.model_id,
        message.sample_period,
        [np.array(shapelet.values, dtype=np.float32) for shapelet in message.shapelets],
        np.array([shapelet.dilation for shapelet in message.shapelets]),
        [
            Cluster(name, centroid.size, np.array(centroid.values, dtype=np.float32))
            for name, centroid in zip(message.cluster_labels, message.centroids)
        ],
        message,
    )


def table(episodes):
    """Returns one row for each episode as a pandas.DataFrame. Needs pandas."""
    import pandas  # pylint: disable=import-outside-toplevel

    columns = ["id", "start", "duration", "complete", "outcome", "event", "confidence", "novelty"]
    rows = [[getattr(episode, column) for column in columns] for episode in episodes]
    frame = pandas.DataFrame(rows, columns=columns).rename(columns={"id": "episode_id"})
    frame["peak"] = [float(np.max(episode.force)) if len(episode.force) else 0.0 for episode in episodes]
    return frame
