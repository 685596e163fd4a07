#include "cli/event_scores.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "cli/text.h"

namespace contact_shapelets::cli {
namespace {

Eigen::VectorXi NearestClusters(const std::vector<NamedEpisode>& named) {
  Eigen::VectorXi clusters(named.size());
  for (std::size_t index = 0; index < named.size(); ++index) {
    clusters[static_cast<Eigen::Index>(index)] = named[index].nearest_cluster;
  }
  return clusters;
}

std::string ClusterText(int cluster, const std::string& name) {
  return "cluster " + std::to_string(cluster) + " is called " + name;
}

}  // namespace

std::vector<NamedEpisode> NamedEpisodes(const std::vector<core::Classification>& results) {
  std::vector<NamedEpisode> named;
  named.reserve(results.size());
  for (const core::Classification& result : results) {
    named.push_back({result.diagnosis.event, result.diagnosis.nearest_cluster});
  }
  return named;
}

EventScores::EventScores(const core::Model& model, const std::vector<core::Episode>& episodes,
                         const std::vector<NamedEpisode>& named)
    : in_cluster_(model.clusters.size()) {
  if (named.size() != episodes.size()) throw std::invalid_argument("there must be one event for each episode");
  for (const core::Cluster& cluster : model.clusters) names_.push_back(cluster.label);
  const std::string unknown = model.EventOf(-1);
  std::set<std::string> events;
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const std::string& outcome = episodes[index].outcome;
    const auto& [event, cluster] = named[index];
    if (outcome.empty()) continue;
    ++episodes_;
    ++confusion_[outcome][event];
    if (event == unknown) {
      ++unknown_;
      continue;
    }
    right_ += event == outcome ? 1 : 0;
    events.insert(event);
    ++in_cluster_.at(static_cast<std::size_t>(cluster))[outcome];
  }
  for (const auto& [outcome, ignored] : confusion_) {
    outcomes_.push_back(outcome);
    if (IsNamed(outcome)) events.insert(outcome);
  }
  events.erase(unknown);
  events_.assign(events.begin(), events.end());
  events_.push_back(unknown);
  indices_ = evaluation::CompareWithOutcomes(NearestClusters(named), episodes);
}

int EventScores::CountOf(const std::string& outcome, const std::string& event) const {
  const auto row = confusion_.find(outcome);
  if (row == confusion_.end()) return 0;
  const auto cell = row->second.find(event);
  return cell == row->second.end() ? 0 : cell->second;
}

bool EventScores::IsNamed(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::string EventScores::Summary() const {
  return "events right: " + std::to_string(right_) + " of " + std::to_string(episodes_) + " (unknown " +
         std::to_string(unknown_) + ")";
}

void EventScores::AddMinorities(std::vector<std::string>* warnings) const {
  for (std::size_t cluster = 0; cluster < names_.size(); ++cluster) {
    const std::map<std::string, int>& counts = in_cluster_[cluster];
    if (names_[cluster].empty() || counts.empty()) continue;
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& left, const auto& right) { return left.second < right.second; });
    const auto own = counts.find(names_[cluster]);
    if (own != counts.end() && own->second >= most->second) continue;
    warnings->push_back("warning: " + ClusterText(static_cast<int>(cluster), names_[cluster]) + ", but most of it is " +
                        most->first + " (" + CountsText(counts) + ")");
  }
}

std::vector<std::string> EventScores::Warnings() const {
  std::vector<std::string> warnings;
  if (episodes_ == 0) return warnings;
  AddMinorities(&warnings);
  for (const std::string& outcome : outcomes_) {
    if (IsNamed(outcome)) continue;
    int count = 0;
    for (const auto& [event, episodes] : confusion_.at(outcome)) count += episodes;
    warnings.push_back("warning: no cluster is called " + outcome + " (" +
                       Count(static_cast<std::size_t>(count), "episode") + ")");
  }
  std::map<std::string, std::vector<std::string>> sharing;
  for (std::size_t cluster = 0; cluster < names_.size(); ++cluster) {
    if (!names_[cluster].empty()) sharing[names_[cluster]].push_back(std::to_string(cluster));
  }
  for (const auto& [name, clusters] : sharing) {
    if (clusters.size() > 1) warnings.push_back("note: clusters " + Joined(clusters, ", ") + " are all called " + name);
  }
  return warnings;
}

std::string EventScores::Indices() const {
  if (!indices_) return "";
  const evaluation::PartitionScores& scores = indices_->scores;
  return "clusters against outcomes: Rand index " + Number(scores.rand_index, 4) + ", ARI " +
         Number(scores.adjusted_rand_index, 4) + ", NMI " + Number(scores.normalised_mutual_information, 4);
}

void EventScores::PrintTable() const {
  const std::string corner = "outcome \\ event";
  std::size_t width = corner.size();
  for (const std::string& outcome : outcomes_) width = std::max(width, outcome.size());
  const auto print = [this, width](const std::string& head, const auto& cell_of) {
    std::string line = "  " + Padded(head, width);
    for (const std::string& event : events_) {
      const std::string cell = cell_of(event);
      const std::size_t cell_width = std::max<std::size_t>(event.size(), 5);
      line += "  " + std::string(cell_width - std::min(cell_width, cell.size()), ' ') + cell;
    }
    std::printf("%s\n", line.c_str());
  };
  print(corner, [](const std::string& event) { return event; });
  for (const std::string& outcome : outcomes_) {
    print(outcome, [&](const std::string& event) { return std::to_string(CountOf(outcome, event)); });
  }
}

void EventScores::Print() const {
  if (episodes_ == 0) return;
  std::printf("%s\n", Summary().c_str());
  PrintTable();
  for (const std::string& warning : Warnings()) std::printf("%s\n", warning.c_str());
  if (indices_) std::printf("%s\n", Indices().c_str());
}

}  // namespace contact_shapelets::cli
