#include "core/matching/ncc_low_blocks.h"

#include <cmath>

namespace contact_shapelets::core {

void ShapeletHistory::Add(const ShapeletSet& shapelets) {
  ++step_;
  shapelets_.push_front(shapelets.normalised());
  if (shapelets_.size() > kSteps) shapelets_.pop_back();
  moved_.resize(shapelets_.size());
  const float root = std::sqrt(static_cast<float>(shapelets.length()));
  for (std::size_t age = 0; age < shapelets_.size(); ++age) {
    moved_[age] = (shapelets_.front() - shapelets_[age]).colwise().norm().transpose() / root;
  }
}

float ShapeletHistory::Moved(int step, int k) const {
  constexpr float kAnything = 4.0F;
  const auto age = static_cast<std::size_t>(step_ - step);
  return step < 0 || age >= moved_.size() ? kAnything : moved_[age][k];
}

}  // namespace contact_shapelets::core
