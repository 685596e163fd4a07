#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_tile.h"

/// \file
/// Shapelets and windows laid out for the inner loops.

namespace contact_shapelets::core {

/// Shapelets that overlap a window by their first samples (`prefix`) or by their last ones, taken in reverse.
struct OverlapSide {
  Eigen::MatrixXf values;  ///< [kGroup, M G]: of group g at column M g, from the end that always overlaps
  Eigen::MatrixXf within;  ///< [kGroup, M G]: sums of the first values; the overlap of 0 samples at column M g
  Eigen::MatrixXf energy;  ///< [kGroup, M G]: the part of the energy in the first values, in the same way
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
  /// Takes the windows of `stretch` in place of those before; `block` is that of the shapelets. Memory is kept.
  void Prepare(const tile::Loops& loops, const WindowSet& windows, const WindowStretch& stretch, int block,
               bool with_bounds);

  int first() const { return first_; }
  int count() const { return count_; }
  /// Tiles that hold the positions of all windows.
  int full_tiles() const { return (count_ + tile_ - 1) / tile_; }
  /// Tiles that hold the positions beyond these, on either side, that partial overlaps reach.
  int further_tiles() const { return further_tiles_; }
  /// Both, those before position 0 first.
  int all_tiles() const { return full_tiles() + 2 * further_tiles_; }
  /// Windows too close to their rounding for single precision, counted from the first one of the set.
  const std::vector<int>& hard() const { return hard_; }

  const float* series() const { return Column(kSeries); }
  const float* mean() const { return Column(kMean); }
  const float* spread() const { return Column(kSpread); }
  const float* scale() const { return Column(kScale); }
  /// Bounds by tile for the overlaps of a direction, 1 or -1; null where there are none.
  const tile::Bounds* bounds(int direction) const {
    return bounds_.empty() ? nullptr : bounds_.data() + further_tiles_ + (direction > 0 ? 0 : all_tiles());
  }

 private:
  /// Columns: these by position or window, sums before a sample, and what the making of the bounds needs.
  enum : int {
    kSeries,
    kMean,
    kSpread,
    kScale,
    kSums,
    kSquares,
    kColumnsWithoutBounds,
    kHeads = kColumnsWithoutBounds,
    kTails,
    kEnergyScale,
    kBeforeWindow,
    kToWindowEnd,
    kColumns
  };

  const float* Column(int index) const { return values_.data() + index * stride_ + margin_; }
  float* Column(int index) { return values_.data() + index * stride_ + margin_; }
  /// Sets what a column has before its first and from its `count`-th value on.
  void SetMargins(int column, int count, float before, float behind);
  void FillSeries(const WindowSet& windows);
  void FillWindows(const tile::Loops& loops, const WindowSet& windows);
  void FillBounds(const tile::Loops& loops, int block);

  int length_ = 0;
  int first_ = 0;
  int count_ = 0;
  int tile_ = 1;
  int further_tiles_ = 0;
  int margin_ = 0;  ///< what positions may jut out
  int stride_ = 0;  ///< between columns
  double centre_ = 0.0;
  std::vector<float> values_;  ///< by position or window in columns, all with a margin on both sides
  std::vector<tile::Bounds> bounds_;
  std::vector<int> hard_;
};

/// What a search writes to, kept from one to the next.
struct SearchMemory::Arrays {
  PreparedWindows windows;
  std::vector<float> sums;     ///< full overlaps of a group of shapelets
  std::vector<float> largest;  ///< of these in each tile, interleaved
};

}  // namespace contact_shapelets::core
