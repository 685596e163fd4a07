#include "ros/parameters/parameters.h"

#include <ros/console.h>

#include <algorithm>
#include <limits>
#include <regex>

#include "core/numerics/interval.h"
#include "ros/messages/names.h"
#include "ros/messages/text.h"

namespace contact_shapelets {
namespace {

using XmlRpc::XmlRpcValue;

const std::map<std::string, core::SegmentationMode> kSegmentations{{"trigger", core::SegmentationMode::kTrigger},
                                                                   {"contact", core::SegmentationMode::kContact},
                                                                   {"action", core::SegmentationMode::kAction}};
const std::map<std::string, core::TareSource> kTareSources{{"episode_start", core::TareSource::kEpisodeStart},
                                                           {"free_air", core::TareSource::kFreeAir},
                                                           {"service", core::TareSource::kService}};
const std::map<std::string, core::Objective> kObjectives{{"contrastive", core::Objective::kContrastive},
                                                         {"paper", core::Objective::kPaper}};

constexpr char kNumber[] = "a number";
constexpr char kNumbers[] = "a list of numbers";

/// Returns the spelling that makes rosparam read a text such as 1e-2 as a number; an empty string for other texts.
std::string SpellingOf(const std::string& text) {
  if (text.size() > kLongestNumber) return "";
  const std::regex number("([-+]?)([0-9]*)\\.?([0-9]*)([eE]([-+]?)([0-9]+))?");
  std::smatch parts;
  if (!std::regex_match(text, parts, number) || parts.length(2) + parts.length(3) == 0) return "";
  const auto or_else = [&parts](std::size_t part, const char* otherwise) {
    return parts.length(part) > 0 ? parts.str(part) : otherwise;
  };
  const bool power = parts.length(4) > 0;
  if (!power && parts.length(2) > 0) return "";
  const std::string spelling =
      parts.str(1) + or_else(2, "0") + "." + or_else(3, "0") + (power ? "e" + or_else(5, "+") + parts.str(6) : "");
  return spelling == text ? "" : spelling;
}

/// Returns the same for a value, or for the first such item of a list.
std::string SpellingOf(XmlRpcValue value) {
  if (value.getType() == XmlRpcValue::TypeString) return SpellingOf(static_cast<std::string&>(value));
  if (value.getType() != XmlRpcValue::TypeArray) return "";
  std::string spelling;
  for (int index = 0; index < value.size() && spelling.empty(); ++index) spelling = SpellingOf(value[index]);
  return spelling;
}

double ToNumber(const XmlRpcValue& value) {
  // The accessors of XmlRpcValue are not const in all versions.
  XmlRpcValue copy = value;
  return copy.getType() == XmlRpcValue::TypeInt ? static_cast<double>(static_cast<int&>(copy))
                                                : static_cast<double&>(copy);
}

bool IsNumber(const XmlRpcValue& value) {
  return value.getType() == XmlRpcValue::TypeInt || value.getType() == XmlRpcValue::TypeDouble;
}

}  // namespace

ParameterReader::ParameterReader(const XmlRpcValue& tree) : tree_(tree) {}

ParameterReader::ParameterReader(const ros::NodeHandle& node_handle) {
  node_handle.getParam(node_handle.getNamespace(), tree_);
}

const XmlRpcValue* ParameterReader::Find(const std::string& name, const std::string& expected,
                                         std::initializer_list<XmlRpcValue::Type> types) {
  read_.insert(name);
  if (tree_.getType() != XmlRpcValue::TypeStruct || !tree_.hasMember(name)) return nullptr;
  const XmlRpcValue& value = tree_[name];
  if (std::find(types.begin(), types.end(), value.getType()) != types.end()) return &value;
  AddTypeFault(name, expected);
  return nullptr;
}

void ParameterReader::AddTypeFault(const std::string& name, const std::string& expected) {
  const XmlRpcValue& value = tree_[name];
  faults_ << name << " must be " << expected << ", but ";
  if (value.valid()) {
    faults_ << "is " << value;
  } else {
    faults_ << "has no value";
  }
  const std::string spelling = expected == kNumber || expected == kNumbers ? SpellingOf(value) : "";
  if (!spelling.empty()) faults_ << ", which rosparam takes for a text: write " << spelling;
  faults_ << '\n';
}

void ParameterReader::Read(const std::string& name, double* value) {
  if (const auto* found = Find(name, kNumber, {XmlRpcValue::TypeInt, XmlRpcValue::TypeDouble})) {
    Replace(name, ToNumber(*found), value);
  }
}

void ParameterReader::Read(const std::string& name, int* value) {
  if (const auto* found = Find(name, "a whole number", {XmlRpcValue::TypeInt})) {
    Replace(name, static_cast<int>(ToNumber(*found)), value);
  }
}

void ParameterReader::Read(const std::string& name, bool* value) {
  if (const auto* found = Find(name, "true or false", {XmlRpcValue::TypeBoolean})) {
    XmlRpcValue copy = *found;
    Replace(name, static_cast<bool&>(copy), value);
  }
}

void ParameterReader::Read(const std::string& name, std::string* value) {
  if (const auto* found = Find(name, "a text", {XmlRpcValue::TypeString})) {
    XmlRpcValue copy = *found;
    Replace(name, static_cast<std::string&>(copy), value);
  }
}

void ParameterReader::Read(const std::string& name, std::uint64_t* value) {
  int number = static_cast<int>(*value);
  Read(name, &number);
  core::CheckRange(name, number, {0, std::numeric_limits<int>::max()}, &faults_);
  *value = static_cast<std::uint64_t>(std::max(0, number));
}

void ParameterReader::Read(const std::string& name, std::vector<double>* value) {
  const auto* found = Find(name, kNumbers, {XmlRpcValue::TypeArray});
  if (found == nullptr) return;
  std::vector<double> numbers;
  for (int index = 0; index < found->size(); ++index) {
    const XmlRpcValue& item = (*found)[index];
    if (!IsNumber(item)) return AddTypeFault(name, kNumbers);
    numbers.push_back(ToNumber(item));
  }
  Replace(name, numbers, value);
}

void ParameterReader::Read(const std::string& name, std::vector<std::string>* value) {
  const auto* found = Find(name, "a list of texts", {XmlRpcValue::TypeArray, XmlRpcValue::TypeString});
  if (found == nullptr) return;
  std::vector<std::string> words;
  if (found->getType() == XmlRpcValue::TypeString) {
    XmlRpcValue copy = *found;
    std::istringstream text(static_cast<std::string&>(copy));
    for (std::string word; text >> word;) words.push_back(word);
  } else {
    for (int index = 0; index < found->size(); ++index) {
      XmlRpcValue item = (*found)[index];
      if (item.getType() != XmlRpcValue::TypeString) return AddTypeFault(name, "a list of texts");
      words.push_back(static_cast<std::string&>(item));
    }
  }
  Replace(name, words, value);
}

std::vector<std::string> ParameterReader::Unread() const {
  std::vector<std::string> names;
  if (tree_.getType() != XmlRpcValue::TypeStruct) return names;
  XmlRpcValue tree = tree_;
  for (const auto& [name, ignored] : tree) {
    if (read_.count(name) == 0) names.push_back(name);
  }
  return names;
}

std::vector<std::string> ParameterReader::Unset() const {
  std::vector<std::string> names;
  for (const std::string& name : read_) {
    if (tree_.getType() != XmlRpcValue::TypeStruct || !tree_.hasMember(name)) names.push_back(name);
  }
  return names;
}

std::string ClassifierOptions::Faults() const {
  std::ostringstream faults;
  core::CheckRange("early_minimum", early_minimum, {0, 1}, &faults);
  if (change_reference != 0) core::CheckRange("change_reference", change_reference, {10, 100'000}, &faults);
  core::CheckRange("change_false_alarms", change_false_alarms, {0, 1, true, true}, &faults);
  return faults.str();
}

core::SegmentationOptions ReadSegmentationOptions(ParameterReader* reader, const core::SegmentationOptions& defaults) {
  core::SegmentationOptions options = defaults;
  reader->Read(parameters::kSegmentation, kSegmentations, &options.segmentation);
  reader->Read(parameters::kTare, kTareSources, &options.tare);
  reader->Read(parameters::kSamplePeriod, &options.sample_period);
  reader->Read(parameters::kTareDuration, &options.tare_duration);
  reader->Read(parameters::kMinDuration, &options.min_duration);
  reader->Read(parameters::kMaxDuration, &options.max_duration);
  reader->Read(parameters::kMaxGap, &options.max_gap);
  reader->Read(parameters::kStreamTimeout, &options.stream_timeout);
  reader->Read(parameters::kEdgeWait, &options.edge_wait);
  reader->Read(parameters::kEdgeMatchWindow, &options.edge_match_window);
  reader->Read(parameters::kContactOn, &options.contact_on);
  reader->Read(parameters::kContactOff, &options.contact_off);
  reader->Read(parameters::kContactHoldOn, &options.contact_hold_on);
  reader->Read(parameters::kContactHoldOff, &options.contact_hold_off);
  reader->Read(parameters::kPreTrigger, &options.pre_trigger);
  reader->Read(parameters::kBaselineDuration, &options.baseline_duration);
  reader->AddFaults(options.Faults());
  return options;
}

EpisodeOptions ReadEpisodeOptions(ParameterReader* reader, const core::SegmentationOptions& defaults) {
  EpisodeOptions options;
  options.segmentation = ReadSegmentationOptions(reader, defaults);
  reader->Read(parameters::kProgressRate, &options.progress_rate);
  std::ostringstream faults;
  core::CheckRange("progress_rate", options.progress_rate, {0, 100}, &faults, " Hz");
  reader->AddFaults(faults.str());
  return options;
}

core::TrainerOptions ReadTrainerOptions(ParameterReader* reader) {
  core::TrainerOptions options;
  core::LearnerOptions& learner = options.learner;
  reader->Read(parameters::kClusters, &options.clusters);
  reader->Read(parameters::kKmeansRestarts, &options.kmeans_restarts);
  reader->Read(parameters::kLogDistances, &options.log_distances);
  reader->Read(parameters::kVoters, &options.voters);
  reader->Read(parameters::kRandomShapelets, &options.random_shapelets);
  reader->Read(parameters::kVotingEpisodes, &options.voting_episodes);
  reader->Read(parameters::kNoveltyQuantile, &options.novelty_quantile);
  reader->Read(parameters::kNoveltyMargin, &options.novelty_margin);
  reader->Read(parameters::kThreads, &options.threads);
  reader->Read(parameters::kIncomplete, &options.incomplete);
  reader->Read(parameters::kSeed, &options.seed);
  reader->Read(parameters::kScales, &learner.scales);
  reader->Read(parameters::kObjective, kObjectives, &learner.objective);
  reader->Read(parameters::kRepulsion, &learner.repulsion);
  reader->Read(parameters::kDiversity, &learner.diversity);
  reader->Read(parameters::kSparsity, &learner.sparsity);
  reader->Read(parameters::kFlatFraction, &learner.flat_fraction);
  reader->Read(parameters::kSteps, &learner.steps);
  reader->Read(parameters::kLearningRate, &learner.learning_rate);
  reader->Read(parameters::kBatch, &learner.batch);
  reader->Read(parameters::kStartWindows, &learner.start_windows);
  reader->Read(parameters::kShortest, &learner.shortest);
  reader->AddFaults(options.Faults());
  return options;
}

ClassifierOptions ReadClassifierOptions(ParameterReader* reader) {
  ClassifierOptions options;
  reader->Read(parameters::kModel, &options.model);
  reader->Read(parameters::kEarly, &options.early);
  reader->Read(parameters::kEarlyMinimum, &options.early_minimum);
  reader->Read(parameters::kChangeReference, &options.change_reference);
  reader->Read(parameters::kChangeFalseAlarms, &options.change_false_alarms);
  reader->AddFaults(options.Faults());
  return options;
}

WrenchAdapterOptions ReadAdapterOptions(ParameterReader* reader) {
  WrenchAdapterOptions options;
  reader->Read(parameters::kSource, {{"wrench", false}, {"joint_torques", true}}, &options.from_torques);
  reader->Read(parameters::kField, &options.field);
  reader->Read(parameters::kFrameId, &options.frame_id);
  reader->Read(parameters::kDamping, &options.damping);
  reader->Read(parameters::kBaseLink, &options.base_link);
  reader->Read(parameters::kTipLink, &options.tip_link);
  reader->AddFaults(options.Faults());
  return options;
}

void LogParameters(const ParameterReader& reader) {
  for (const std::string& name : reader.Unread()) {
    // The diagnostic updater has its own parameters.
    if (name.rfind("diagnostic_", 0) != 0) ROS_WARN("~%s is not a parameter of this node", name.c_str());
  }
  for (const std::string& name : reader.Changed()) ROS_INFO("~%s is not at its default", name.c_str());
}

}  // namespace contact_shapelets
