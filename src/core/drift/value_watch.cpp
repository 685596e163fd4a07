#include "core/drift/value_watch.h"

#include <algorithm>
#include <utility>

namespace contact_shapelets::core {

ValueWatch::ValueWatch(std::vector<double> training) : sorted_(std::move(training)) {
  std::sort(sorted_.begin(), sorted_.end());
}

void ValueWatch::Append(double value, double uniform) {
  const auto [begin, end] = std::equal_range(sorted_.begin(), sorted_.end(), value);
  const double greater = static_cast<double>(sorted_.end() - end);
  const double ties = static_cast<double>(end - begin) + 1.0;
  const double all = static_cast<double>(sorted_.size()) + 1.0;
  // Both are above 0: log(0) would end the bets.
  const double share = std::max(uniform, 1e-9);
  greater_.Append((greater + share * ties) / all);
  smaller_.Append((all - greater - ties + (1.0 - share) * ties) / all);
  sorted_.insert(end, value);
  ++count_;
}

}  // namespace contact_shapelets::core
