#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "contact_shapelets/core/segmentation_options.h"
#include "contact_shapelets/core/trainer.h"
#include "ros/adapters/wrench_adapter_options.h"

/// \file
/// Parameters from the parameter server or a YAML file into the plain structs of options, by the same code.

namespace contact_shapelets {

/// Reads named values out of a tree of parameters, and collects everything that is wrong with them.
class ParameterReader {
 public:
  /// Reads from `tree`, a struct (or invalid: no parameter is set).
  explicit ParameterReader(const XmlRpc::XmlRpcValue& tree);
  /// Reads from the namespace of `node_handle`.
  explicit ParameterReader(const ros::NodeHandle& node_handle);
  /// Reads from YAML files, later ones winning. Values are of the types that rosparam would give them: 1e-2 is a text.
  /// \throws std::runtime_error naming a file that cannot be read.
  static ParameterReader FromYaml(const std::vector<std::string>& paths);

  /// Sets `value` where the parameter is set; notes a fault where it is of another type.
  void Read(const std::string& name, double* value);
  void Read(const std::string& name, int* value);
  void Read(const std::string& name, bool* value);
  void Read(const std::string& name, std::string* value);
  void Read(const std::string& name, std::uint64_t* value);
  void Read(const std::string& name, std::vector<double>* value);
  /// A list of strings, or one string with several separated by spaces.
  void Read(const std::string& name, std::vector<std::string>* value);
  /// One of several words.
  template <typename Choice>
  void Read(const std::string& name, const std::map<std::string, Choice>& choices, Choice* value);

  /// Notes faults that a validator found.
  void AddFaults(const std::string& faults) { faults_ << faults; }
  /// Every fault so far, one per line.
  std::string Faults() const { return faults_.str(); }
  /// Names of parameters that are set, but that nothing read.
  std::vector<std::string> Unread() const;
  /// Names of parameters that were read, but are not set, so that their defaults count.
  std::vector<std::string> Unset() const;
  /// Names of parameters whose value, as read, differs from the default that it replaced.
  const std::set<std::string>& Changed() const { return changed_; }

 private:
  template <typename Value>
  void Replace(const std::string& name, const Value& found, Value* value);
  const XmlRpc::XmlRpcValue* Find(const std::string& name, const std::string& expected,
                                  std::initializer_list<XmlRpc::XmlRpcValue::Type> types);
  void AddTypeFault(const std::string& name, const std::string& expected);

  XmlRpc::XmlRpcValue tree_;
  std::set<std::string> read_;
  std::set<std::string> changed_;
  std::ostringstream faults_;
};

/// What the episode node is told.
struct EpisodeOptions {
  core::SegmentationOptions segmentation;
  double progress_rate = 20.0;  ///< [Hz] of episode_progress, [0, 100]; 0: never
};

/// What the classifier node is told.
struct ClassifierOptions {
  std::string model;            ///< path of a model file; empty: the model comes by topic
  bool early = true;            ///< publish early diagnoses of open episodes
  double early_minimum = 0.25;  ///< part of the typical duration before the first early diagnosis, [0, 1]

  /// Every parameter that is out of range, one line each.
  std::string Faults() const;
};

/// Parameters of the segmentation; faults are noted in `reader`.
core::SegmentationOptions ReadSegmentationOptions(ParameterReader* reader);
/// Parameters of the episode node, the segmentation's included; faults are noted in `reader`.
EpisodeOptions ReadEpisodeOptions(ParameterReader* reader);
/// Parameters of the trainer; faults are noted in `reader`.
core::TrainerOptions ReadTrainerOptions(ParameterReader* reader);
/// Parameters of the classifier node; faults are noted in `reader`.
ClassifierOptions ReadClassifierOptions(ParameterReader* reader);

/// Parameters of the wrench adapter node; faults are noted in `reader`.
WrenchAdapterOptions ReadAdapterOptions(ParameterReader* reader);

/// Logs which parameters a node has that it does not know (as warnings) and which differ from their defaults.
void LogParameters(const ParameterReader& reader);

template <typename Value>
void ParameterReader::Replace(const std::string& name, const Value& found, Value* value) {
  if (!(found == *value)) changed_.insert(name);
  *value = found;
}

template <typename Choice>
void ParameterReader::Read(const std::string& name, const std::map<std::string, Choice>& choices, Choice* value) {
  std::string word;
  std::string words;
  for (const auto& [allowed, choice] : choices) {
    if (choice == *value) word = allowed;
    words += (words.empty() ? "" : ", ") + allowed;
  }
  Read(name, &word);
  const auto choice = choices.find(word);
  if (choice != choices.end()) {
    *value = choice->second;
  } else {
    faults_ << name << " must be one of " << words << ", but is \"" << word << "\"\n";
  }
}

}  // namespace contact_shapelets
