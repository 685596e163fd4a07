#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact_shapelets/core/ncc.h"
#include "core/ncc_tile.h"

/// \file
/// Shapelets and windows laid out for the inner loops.

namespace contact_shapelets::core {

/// Shapelets that overlap a window by their first samples (`prefix`) or by their last ones, taken in reverse.
struct OverlapSide {
  Eigen::MatrixXf values;  ///< [kGroup, M G]: of group g at column M g, from the end that always overlaps
  Eigen::MatrixXf within;  ///< [kGroup, M G]: sums of the first values; the overlap of 0 samples at column M g
  std::vector<tile::Energies> energies;  ///< [kGroup G]
};

/// The shapelets of one set, in G groups of tile::kGroup; zeros fill the last one.
struct PreparedShapelets {
  explicit PreparedShapelets(const Eigen::Ref<const Eigen::MatrixXf>& normalised);

  int length;
  int groups;
  int block;  ///< overlaps in a block
  std::vector<bool> constant;
  OverlapSide prefix;
  OverlapSide suffix;
};

/// A stretch of windows, on values centred on their own mean; positions are counted from the first window of the
/// stretch.
class PreparedWindows {
 public:
  /// Takes `count` windows from `first` on.
  PreparedWindows(const tile::Loops& loops, const WindowSet& windows, int first, int count, int block, bool prune);

  int first() const { return first_; }
  int count() const { return count_; }
  /// Tiles that hold the positions of all windows.
  int full_tiles() const { return (count_ + tile_ - 1) / tile_; }
  /// Tiles that hold the positions beyond these, on either side, that partial overlaps reach.
  int further_tiles() const { return further_tiles_; }
  /// Windows too close to their rounding for single precision, counted from the first one of the set.
  const std::vector<int>& hard() const { return hard_; }

  const float* series() const { return Column(0); }
  const float* mean() const { return Column(1); }
  const float* spread() const { return Column(2); }
  const float* scale() const { return Column(3); }
  /// Bounds by tile for the overlaps of a direction, 1 or -1.
  const tile::Bounds* bounds(int direction) const {
    return bounds_.data() + further_tiles_ + (direction > 0 ? 0 : all_tiles());
  }

 private:
  int all_tiles() const { return full_tiles() + 2 * further_tiles_; }
  const float* Column(int index) const { return &values_(margin_, index); }
  float* Column(int index) { return &values_(margin_, index); }
  void FillSeries(const WindowSet& windows);
  void FillWindows(const tile::Loops& loops, const WindowSet& windows);
  void FillBounds(const tile::Loops& loops, bool prune);

  int length_;
  int first_;
  int count_;
  int tile_;
  int further_tiles_;
  int margin_;  ///< what positions may jut out
  int block_;
  double centre_ = 0.0;
  Eigen::ArrayXXf values_;  ///< by position or window in columns, all with a margin on both sides: see the functions
                            ///< above; then the sums and squared sums before a sample, and scratch
  std::vector<tile::Bounds> bounds_;
  std::vector<int> hard_;
};

}  // namespace contact_shapelets::core
