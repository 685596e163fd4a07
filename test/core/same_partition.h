#pragma once

#include <Eigen/Core>
#include <map>

namespace contact_shapelets::core {

/// Returns true if `one` and `other` [N] split the items alike, whatever the numbers of the parts.
inline bool SamePartition(const Eigen::Ref<const Eigen::VectorXi>& one,
                          const Eigen::Ref<const Eigen::VectorXi>& other) {
  if (one.size() != other.size()) return false;
  std::map<int, int> forward;
  std::map<int, int> backward;
  for (Eigen::Index item = 0; item < one.size(); ++item) {
    if (forward.emplace(one[item], other[item]).first->second != other[item]) return false;
    if (backward.emplace(other[item], one[item]).first->second != one[item]) return false;
  }
  return true;
}

}  // namespace contact_shapelets::core
