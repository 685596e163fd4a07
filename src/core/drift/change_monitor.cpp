#include "core/drift/change_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

/// The median; not a number if there are no values.
double Median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// The median of one trait, without the episode of index `left_out`.
double MedianOf(const std::vector<Traits>& episodes, std::size_t trait, std::size_t left_out) {
  std::vector<double> values;
  values.reserve(episodes.size());
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    if (index != left_out && !std::isnan(episodes[index][trait])) values.push_back(episodes[index][trait]);
  }
  return Median(std::move(values));
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// What each training episode lies above the median of the others in its group, as a new one lies above all of them.
std::vector<double> Residuals(const std::map<int, std::vector<Traits>>& groups, std::size_t trait) {
  std::vector<double> residuals;
  for (const auto& [group, episodes] : groups) {
    for (std::size_t index = 0; index < episodes.size(); ++index) {
      const double residual = episodes[index][trait] - MedianOf(episodes, trait, index);
      if (!std::isnan(residual)) residuals.push_back(residual);
    }
  }
  return residuals;
}

}  // namespace

std::string NameOf(Trait trait) {
  switch (trait) {
    case Trait::kMeanForce:
      return "mean force";
    case Trait::kGreatestForce:
      return "greatest force";
    case Trait::kForceDeviation:
      return "standard deviation of the force";
    case Trait::kDuration:
      return "duration";
    case Trait::kNovelty:
      return "novelty";
  }
  return "";
}

Traits TraitsOf(const Episode& episode, double novelty) {
  const double least = 1e-3;
  const Eigen::VectorXd force = episode.force.cast<double>();
  const double mean = force.mean();
  const double deviation = std::sqrt((force.array() - mean).square().mean());
  return {std::log(std::max(mean, least)), std::log(std::max(force.maxCoeff(), least)),
          std::log(std::max(deviation, least)), std::log(std::max(episode.duration(), least)),
          std::log(std::max(novelty, least))};
}

ChangeMonitor::ChangeMonitor(const std::vector<WatchedEpisode>& training, const ChangeOptions& options)
    : options_(options), random_(options.seed), log_evidence_(-std::numeric_limits<double>::infinity()) {
  if (!(options.false_alarm_probability > 0.0 && options.false_alarm_probability < 1.0))
    throw std::invalid_argument("expected a false alarm probability in (0, 1), but found " +
                                std::to_string(options.false_alarm_probability));
  rates_.emplace("unknown", ValueWatch({}));
  for (const WatchedEpisode& episode : training) {
    training_[episode.group].push_back(episode.traits);
    rates_.emplace(episode.event, ValueWatch({}));
  }
  for (const auto& [group, episodes] : training_) {
    for (std::size_t trait = 0; trait < kTraits; ++trait) {
      medians_[group][trait] = MedianOf(episodes, trait, kNone);
      std::vector<double> values;
      for (const Traits& traits : episodes) {
        if (!std::isnan(traits[trait])) values.push_back(traits[trait]);
      }
      groups_[group].traits.emplace_back(std::move(values));
    }
  }
  for (std::size_t trait = 0; trait < kTraits; ++trait) all_.traits.emplace_back(Residuals(training_, trait));
}

void ChangeMonitor::Append(const WatchedEpisode& episode) {
  episodes_.push_back(episode);
  log_evidence_ = -std::numeric_limits<double>::infinity();
  const auto group = groups_.find(episode.group);
  if (group != groups_.end()) {
    Watch(episode.group, episode.traits, &group->second);
    Traits residuals{};
    for (std::size_t trait = 0; trait < kTraits; ++trait)
      residuals[trait] = episode.traits[trait] - medians_[episode.group][trait];
    Watch(std::nullopt, residuals, &all_);
  }
  WatchRates(episode.event);
}

void ChangeMonitor::Watch(std::optional<int> group, const Traits& values, Watched* watched) {
  const std::size_t watches = 2 * kTraits * (group ? groups_.size() : 1);
  for (std::size_t trait = 0; trait < kTraits; ++trait) {
    if (std::isnan(values[trait])) continue;
    ValueWatch& watch = watched->traits[trait];
    watched->episodes[trait].push_back(count() - 1);
    watch.Append(values[trait], random_.Uniform());
    for (const PowerMartingale* martingale : {&watch.smaller(), &watch.greater()}) {
      if (!Tells(*martingale, watches)) continue;
      const auto start = static_cast<std::size_t>(martingale->LikelyStart());
      change_ = TraitChange(group, trait, watched->episodes[trait][start]);
    }
  }
}

void ChangeMonitor::WatchRates(const std::string& event) {
  for (auto& [name, watch] : rates_) {
    watch.Append(name == event ? 1.0 : 0.0, random_.Uniform());
    // One that becomes rarer makes another more frequent.
    if (Tells(watch.greater(), rates_.size())) change_ = RateChange(name, watch.greater().LikelyStart());
  }
}

bool ChangeMonitor::Tells(const PowerMartingale& martingale, std::size_t watches) {
  const double log_limit = std::log(3.0 * static_cast<double>(watches) / options_.false_alarm_probability);
  const double excess = martingale.LogEvidence() - log_limit;
  log_evidence_ = std::max(log_evidence_, excess);
  return excess > 0.0 && !change_;
}

Change ChangeMonitor::TraitChange(std::optional<int> group, std::size_t trait, std::int64_t first) const {
  std::vector<double> before;
  std::vector<double> since;
  // Counts from the median of the episode's group, because groups may be mixed in other shares than before.
  const auto take = [&](int of, const Traits& traits, std::vector<double>* values) {
    const auto median = medians_.find(of);
    if (median == medians_.end() || (group && of != *group)) return;
    const double residual = traits[trait] - (group ? 0.0 : median->second[trait]);
    if (!std::isnan(residual)) values->push_back(residual);
  };
  std::vector<double> level;
  for (const auto& [of, episodes] : training_) {
    for (const Traits& traits : episodes) {
      take(of, traits, &before);
      if (!group && !std::isnan(traits[trait])) level.push_back(traits[trait]);
    }
  }
  for (std::size_t index = 0; index < episodes_.size(); ++index) {
    const bool changed = static_cast<std::int64_t>(index) >= first;
    take(episodes_[index].group, episodes_[index].traits, changed ? &since : &before);
  }
  const double base = group ? 0.0 : Median(std::move(level));
  Change change;
  change.what = NameOf(static_cast<Trait>(trait));
  change.group = group;
  change.before = std::exp(base + Median(std::move(before)));
  change.since = std::exp(base + Median(std::move(since)));
  change.first = first;
  return change;
}

Change ChangeMonitor::RateChange(const std::string& event, std::int64_t first) const {
  const auto rate = [&](std::int64_t begin, std::int64_t end) {
    const auto number = std::count_if(episodes_.begin() + begin, episodes_.begin() + end,
                                      [&event](const WatchedEpisode& episode) { return episode.event == event; });
    return static_cast<double>(number) / static_cast<double>(std::max<std::int64_t>(end - begin, 1));
  };
  Change change;
  change.what = event;
  change.rate = true;
  change.before = rate(0, first);
  change.since = rate(first, count());
  change.first = first;
  return change;
}

}  // namespace contact_shapelets::core
