#include "core/change_points/streaming_clasp.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "core/change_points/classification_profile.h"
#include "core/change_points/sample_check.h"
#include "core/change_points/window_size.h"

namespace contact_shapelets::core {
namespace {

/// Samples that are worked off per new one. More than one, so that those of the warm-up come to an end.
constexpr std::size_t kCatchUp = 8;

}  // namespace

std::string StreamingClaspOptions::Faults() const {
  std::ostringstream faults;
  const auto require = [&faults](bool well, const char* name, const char* range, double value) {
    if (!well) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  require(window == 0 || window >= 3, "window", "0 or at least 3 samples", window);
  require(warm_up >= 20, "warm_up", "at least 20 samples", warm_up);
  require(sliding_window >= 200, "sliding_window", "at least 200 samples", sliding_window);
  require(neighbours >= 1 && neighbours <= kMostNeighbours, "neighbours", "in [1, 15]", neighbours);
  require(stride >= 1, "stride", "at least 1 sample", stride);
  require(significance > 0.0 && significance < 1.0, "significance", "in (0, 1)", significance);
  require(shortest_segment >= 2, "shortest_segment", "at least 2 windows", shortest_segment);
  return faults.str();
}

StreamingClasp::StreamingClasp(const StreamingClaspOptions& options) : options_(options) {
  const std::string faults = options.Faults();
  if (!faults.empty()) throw std::invalid_argument(faults);
}

std::vector<ChangePoint> StreamingClasp::Append(double sample) {
  CheckSample(sample, appended_);
  ++appended_;
  kept_.push_back(sample);
  if (!neighbours_) {
    if (options_.window == 0 && appended_ < options_.warm_up) return {};
    Start();
  }
  return WorkOff(kCatchUp);
}

std::vector<ChangePoint> StreamingClasp::Flush() {
  if (kept_.empty()) return {};
  if (!neighbours_) Start();
  return WorkOff(kept_.size());
}

void StreamingClasp::Start() {
  window_ = options_.window;
  if (window_ == 0) {
    const std::vector<double> warm_up(kept_.begin(), kept_.end());
    window_ = SelectWindowSize(Eigen::Map<const Eigen::VectorXd>(warm_up.data(), static_cast<int>(warm_up.size())));
    // A few segments must fit into the sliding window, or none would ever be found.
    window_ = std::max(3, std::min(window_, options_.sliding_window / (4 * options_.shortest_segment)));
  }
  neighbours_.emplace(window_, options_.neighbours, options_.sliding_window);
}

std::vector<ChangePoint> StreamingClasp::WorkOff(std::size_t samples) {
  std::vector<ChangePoint> found;
  for (; samples > 0 && !kept_.empty(); --samples) {
    neighbours_->Append(kept_.front());
    kept_.pop_front();
    ++worked_off_;
    if (worked_off_ % options_.stride != 0) continue;
    if (const auto change_point = LookForChange()) found.push_back(*change_point);
  }
  return found;
}

std::optional<ChangePoint> StreamingClasp::LookForChange() {
  const int margin = options_.shortest_segment * window_;
  if (neighbours_->size() < 2 * margin) return std::nullopt;
  const std::optional<Split> split = ClassificationProfile(neighbours_->Votes(), window_).Best(margin);
  if (!split || split->p_value > options_.significance) return std::nullopt;
  const std::int64_t index = worked_off_ - neighbours_->size() + split->index;
  neighbours_->Forget(split->index);
  return ChangePoint{index, split->score, split->p_value};
}

}  // namespace contact_shapelets::core
