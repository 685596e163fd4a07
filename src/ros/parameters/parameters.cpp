#include "ros/parameters/parameters.h"

#include <ros/console.h>

#include <algorithm>
#include <limits>
#include <regex>

#include "core/numerics/interval.h"
#include "ros/messages/text.h"

namespace contact_shapelets {
namespace {

using XmlRpc::XmlRpcValue;

const std::map<std::string, core::Segmentation> kSegmentations{{"trigger", core::Segmentation::kTrigger},
                                                               {"contact", core::Segmentation::kContact},
                                                               {"action", core::Segmentation::kAction}};
const std::map<std::string, core::TareSource> kTareSources{{"episode_start", core::TareSource::kEpisodeStart},
                                                           {"free_air", core::TareSource::kFreeAir},
                                                           {"service", core::TareSource::kService}};
const std::map<std::string, core::Objective> kObjectives{{"contrastive", core::Objective::kContrastive},
                                                         {"paper", core::Objective::kPaper}};

constexpr char kNumber[] = "a number";
constexpr char kNumbers[] = "a list of numbers";

/// How to write a number that rosparam takes for a text, such as 1e-2; empty for other texts.
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

/// Likewise for a value or the first such item of a list.
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
  return faults.str();
}

core::SegmentationOptions ReadSegmentationOptions(ParameterReader* reader) {
  core::SegmentationOptions options;
  reader->Read("segmentation", kSegmentations, &options.segmentation);
  reader->Read("tare", kTareSources, &options.tare);
  reader->Read("sample_period", &options.sample_period);
  reader->Read("tare_duration", &options.tare_duration);
  reader->Read("min_duration", &options.min_duration);
  reader->Read("max_duration", &options.max_duration);
  reader->Read("max_gap", &options.max_gap);
  reader->Read("stream_timeout", &options.stream_timeout);
  reader->Read("edge_wait", &options.edge_wait);
  reader->Read("edge_match_window", &options.edge_match_window);
  reader->Read("contact_on", &options.contact_on);
  reader->Read("contact_off", &options.contact_off);
  reader->Read("contact_hold_on", &options.contact_hold_on);
  reader->Read("contact_hold_off", &options.contact_hold_off);
  reader->Read("pre_trigger", &options.pre_trigger);
  reader->Read("baseline_duration", &options.baseline_duration);
  reader->AddFaults(options.Faults());
  return options;
}

EpisodeOptions ReadEpisodeOptions(ParameterReader* reader) {
  EpisodeOptions options;
  options.segmentation = ReadSegmentationOptions(reader);
  reader->Read("progress_rate", &options.progress_rate);
  std::ostringstream faults;
  core::CheckRange("progress_rate", options.progress_rate, {0, 100}, &faults, " Hz");
  reader->AddFaults(faults.str());
  return options;
}

core::TrainerOptions ReadTrainerOptions(ParameterReader* reader) {
  core::TrainerOptions options;
  core::LearnerOptions& learner = options.learner;
  reader->Read("clusters", &options.clusters);
  reader->Read("kmeans_restarts", &options.kmeans_restarts);
  reader->Read("log_distances", &options.log_distances);
  reader->Read("voters", &options.voters);
  reader->Read("random_shapelets", &options.random_shapelets);
  reader->Read("voting_episodes", &options.voting_episodes);
  reader->Read("novelty_quantile", &options.novelty_quantile);
  reader->Read("novelty_margin", &options.novelty_margin);
  reader->Read("threads", &options.threads);
  reader->Read("incomplete", &options.incomplete);
  reader->Read("seed", &options.seed);
  reader->Read("scales", &learner.scales);
  reader->Read("objective", kObjectives, &learner.objective);
  reader->Read("repulsion", &learner.repulsion);
  reader->Read("diversity", &learner.diversity);
  reader->Read("sparsity", &learner.sparsity);
  reader->Read("flat_fraction", &learner.flat_fraction);
  reader->Read("steps", &learner.steps);
  reader->Read("learning_rate", &learner.learning_rate);
  reader->Read("batch", &learner.batch);
  reader->Read("start_windows", &learner.start_windows);
  reader->Read("shortest", &learner.shortest);
  reader->AddFaults(options.Faults());
  return options;
}

ClassifierOptions ReadClassifierOptions(ParameterReader* reader) {
  ClassifierOptions options;
  reader->Read("model", &options.model);
  reader->Read("early", &options.early);
  reader->Read("early_minimum", &options.early_minimum);
  reader->AddFaults(options.Faults());
  return options;
}

WrenchAdapterOptions ReadAdapterOptions(ParameterReader* reader) {
  WrenchAdapterOptions options;
  reader->Read("source", {{"wrench", false}, {"joint_torques", true}}, &options.from_torques);
  reader->Read("field", &options.field);
  reader->Read("frame_id", &options.frame_id);
  reader->Read("damping", &options.damping);
  reader->Read("base_link", &options.base_link);
  reader->Read("tip_link", &options.tip_link);
  reader->AddFaults(options.Faults());
  return options;
}

void LogParameters(const ParameterReader& reader) {
  for (const std::string& name : reader.Unread()) {
    // The updater of diagnostics has parameters of its own.
    if (name.rfind("diagnostic_", 0) != 0) ROS_WARN("~%s is not a parameter of this node", name.c_str());
  }
  for (const std::string& name : reader.Changed()) ROS_INFO("~%s is not at its default", name.c_str());
}

}  // namespace contact_shapelets
