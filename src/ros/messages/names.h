#pragma once

#include <cstdint>

/// \file
/// Names that users rely on: topics (relative) with their queue sizes, services, actions, and parameters of the nodes.

namespace contact_shapelets {
namespace topics {

constexpr char kWrench[] = "wrench";
constexpr char kEpisodeActive[] = "episode_active";
constexpr char kEpisodeEvent[] = "episode_event";
constexpr char kActionStatus[] = "action_status";
constexpr char kTare[] = "tare";
constexpr char kOutcome[] = "outcome";
constexpr char kEpisode[] = "episode";
constexpr char kEpisodeProgress[] = "episode_progress";
constexpr char kModel[] = "model";
constexpr char kFeatures[] = "features";
constexpr char kDiagnosis[] = "diagnosis";
constexpr char kEvent[] = "event";
/// Inputs of the wrench adapter.
constexpr char kDriverMessage[] = "driver_message";
constexpr char kJointStates[] = "joint_states";

/// Two seconds of a 1 kHz stream, so that a short delay loses no sample.
constexpr std::uint32_t kWrenchQueue = 2000;
constexpr std::uint32_t kEdgeQueue = 100;
constexpr std::uint32_t kResultQueue = 100;
/// Only the newest state of an open episode matters.
constexpr std::uint32_t kProgressQueue = 1;

}  // namespace topics

/// Private services of the nodes.
namespace services {

constexpr char kStart[] = "start";
constexpr char kStop[] = "stop";
constexpr char kTare[] = "tare";
constexpr char kNameCluster[] = "name_cluster";

}  // namespace services

namespace actions {

constexpr char kTrain[] = "train";

}  // namespace actions

/// Private parameters of the nodes, and keys of the files in config/.
namespace parameters {

constexpr char kSegmentation[] = "segmentation";
constexpr char kTare[] = "tare";
constexpr char kSamplePeriod[] = "sample_period";
constexpr char kTareDuration[] = "tare_duration";
constexpr char kMinDuration[] = "min_duration";
constexpr char kMaxDuration[] = "max_duration";
constexpr char kMaxGap[] = "max_gap";
constexpr char kStreamTimeout[] = "stream_timeout";
constexpr char kEdgeWait[] = "edge_wait";
constexpr char kEdgeMatchWindow[] = "edge_match_window";
constexpr char kContactOn[] = "contact_on";
constexpr char kContactOff[] = "contact_off";
constexpr char kContactHoldOn[] = "contact_hold_on";
constexpr char kContactHoldOff[] = "contact_hold_off";
constexpr char kPreTrigger[] = "pre_trigger";
constexpr char kBaselineDuration[] = "baseline_duration";
constexpr char kPreparation[] = "preparation";
constexpr char kProgressRate[] = "progress_rate";
constexpr char kClusters[] = "clusters";
constexpr char kKmeansRestarts[] = "kmeans_restarts";
constexpr char kLogDistances[] = "log_distances";
constexpr char kVoters[] = "voters";
constexpr char kRandomShapelets[] = "random_shapelets";
constexpr char kVotingEpisodes[] = "voting_episodes";
constexpr char kNoveltyQuantile[] = "novelty_quantile";
constexpr char kNoveltyMargin[] = "novelty_margin";
constexpr char kThreads[] = "threads";
constexpr char kIncomplete[] = "incomplete";
constexpr char kSeed[] = "seed";
constexpr char kScales[] = "scales";
constexpr char kObjective[] = "objective";
constexpr char kRepulsion[] = "repulsion";
constexpr char kDiversity[] = "diversity";
constexpr char kSparsity[] = "sparsity";
constexpr char kFlatFraction[] = "flat_fraction";
constexpr char kSteps[] = "steps";
constexpr char kLearningRate[] = "learning_rate";
constexpr char kBatch[] = "batch";
constexpr char kStartWindows[] = "start_windows";
constexpr char kShortest[] = "shortest";
constexpr char kModel[] = "model";
constexpr char kEarly[] = "early";
constexpr char kEarlyMinimum[] = "early_minimum";
constexpr char kChangeReference[] = "change_reference";
constexpr char kChangeFalseAlarms[] = "change_false_alarms";
constexpr char kSource[] = "source";
constexpr char kField[] = "field";
constexpr char kFrameId[] = "frame_id";
constexpr char kDamping[] = "damping";
constexpr char kBaseLink[] = "base_link";
constexpr char kTipLink[] = "tip_link";
constexpr char kWrenchTopic[] = "wrench_topic";
constexpr char kBags[] = "bags";
constexpr char kOutput[] = "output";

}  // namespace parameters
}  // namespace contact_shapelets
