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
#include "contact_shapelets/ros/wrench_source.h"

/// \file
/// Reads options from the parameter server or from YAML files, with the same code.

namespace contact_shapelets {

/// Reads named values from a tree of parameters and collects their faults.
class ParameterReader {
 public:
  /// Reads from `tree`, a struct; an invalid value means that no parameter is set.
  explicit ParameterReader(const XmlRpc::XmlRpcValue& tree);
  /// Reads from the namespace of `node_handle`.
  explicit ParameterReader(const ros::NodeHandle& node_handle);
  /// Reads from YAML files. Later files win. Values have the types that rosparam gives them: 1e-2 is a text.
  /// \throws std::runtime_error naming the file if it cannot be read.
  static ParameterReader FromYaml(const std::vector<std::string>& paths);

  /// Sets `value` if the parameter is set. Adds a fault if it has another type.
  void Read(const std::string& name, double* value);
  void Read(const std::string& name, int* value);
  void Read(const std::string& name, bool* value);
  void Read(const std::string& name, std::string* value);
  void Read(const std::string& name, std::uint64_t* value);
  void Read(const std::string& name, std::vector<double>* value);
  /// Reads a list of strings, or one string with several separated by spaces.
  void Read(const std::string& name, std::vector<std::string>* value);
  /// Reads one of several words.
  template <typename Choice>
  void Read(const std::string& name, const std::map<std::string, Choice>& choices, Choice* value);

  /// Counts `name` as known. Something else reads it.
  void Skip(const std::string& name) { read_.insert(name); }

  /// Adds faults that a validator found.
  void AddFaults(const std::string& faults) { faults_ << faults; }
  /// Returns all faults so far, one per line.
  std::string Faults() const { return faults_.str(); }
  /// Returns the names of parameters that are set, but were not read.
  std::vector<std::string> Unread() const;
  /// Returns the names of parameters that were read, but are not set: their defaults count.
  std::vector<std::string> Unset() const;
  /// Returns the names of parameters that were read and differ from their defaults.
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

/// Options of the episode node.
struct EpisodeOptions {
  core::SegmentationOptions segmentation;
  double progress_rate = 20.0;  ///< [Hz] rate of episode_progress, [0, 100]; 0: never
};

/// Options of the classifier node.
struct ClassifierOptions {
  std::string model;                  ///< path of a model file; if empty, the model comes from the topic
  bool early = true;                  ///< publish early diagnoses of open episodes
  double early_minimum = 0.25;        ///< part of the typical duration before the first early diagnosis, [0, 1]
  int change_reference = 50;          ///< first episodes, which later ones are compared with, [10, 100000]; 0: none are
  double change_false_alarms = 0.05;  ///< probability of ever warning of a change where there is none, (0, 1)

  /// Returns one line for each parameter that is out of range; an empty string if all are valid.
  std::string Faults() const;
};

/// Reads the parameters of the segmentation; those that are not set are as in `defaults`. Adds faults to `reader`.
core::SegmentationOptions ReadSegmentationOptions(ParameterReader* reader,
                                                  const core::SegmentationOptions& defaults = {});
/// Reads the parameters of the episode node, with those of the segmentation. Adds faults to `reader`.
EpisodeOptions ReadEpisodeOptions(ParameterReader* reader, const core::SegmentationOptions& defaults = {});
/// Reads the parameters of the trainer. Adds faults to `reader`.
core::TrainerOptions ReadTrainerOptions(ParameterReader* reader);
/// Reads the parameters of the classifier node. Adds faults to `reader`.
ClassifierOptions ReadClassifierOptions(ParameterReader* reader);

/// Reads the parameters of the wrench adapter node. Adds faults to `reader`.
WrenchAdapterOptions ReadAdapterOptions(ParameterReader* reader);

/// Logs a warning for each unknown parameter, and which parameters differ from their defaults.
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
