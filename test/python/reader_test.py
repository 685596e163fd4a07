#!/usr/bin/python3
"""Tests the Python reader on the shipped bags."""

import pathlib
import unittest

import numpy as np

import contact_shapelets

BAGS = pathlib.Path(__file__).resolve().parents[2] / "bags"


class ReaderTest(unittest.TestCase):
    def test_episodes_are_arrays_with_outcomes(self):
        episodes = contact_shapelets.read_episodes(BAGS / "switch_push_train.bag")
        self.assertGreater(len(episodes), 20)
        first = episodes[0]
        self.assertEqual(first.force.dtype, np.float32)
        self.assertEqual(first.force.shape, first.time.shape)
        self.assertAlmostEqual(first.duration, 4.33, places=6)
        self.assertTrue(all(episode.outcome for episode in episodes))

    def test_a_model_has_a_centroid_for_each_cluster_and_a_feature_for_each_shapelet(self):
        model = contact_shapelets.read_model(BAGS / "switch_push_model.bag")
        self.assertGreater(len(model.shapelets), 10)
        self.assertEqual(len(model.dilations), len(model.shapelets))
        for cluster in model.clusters:
            self.assertEqual(cluster.centroid.shape, (len(model.shapelets),))
        for shapelet in model.shapelets:
            self.assertAlmostEqual(float(shapelet.mean()), 0.0, places=3)

    def test_a_bag_of_another_kind_is_refused_by_its_name(self):
        with self.assertRaisesRegex(ValueError, "switch_push_train.bag: expected one"):
            contact_shapelets.read_model(BAGS / "switch_push_train.bag")
        with self.assertRaisesRegex(ValueError, "switch_push_model.bag: expected contact_shapelets/Episode"):
            contact_shapelets.read_episodes(BAGS / "switch_push_model.bag")

    def test_a_table_has_a_row_for_each_episode(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not there")
        episodes = contact_shapelets.read_episodes(BAGS / "switch_push_test.bag")
        self.assertEqual(len(contact_shapelets.table(episodes)), len(episodes))


if __name__ == "__main__":
    unittest.main()
