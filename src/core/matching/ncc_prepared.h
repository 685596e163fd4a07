#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_tile.h"

/// \file
/// Shapelets and windows as the inner loops need them.

namespace contact_shapelets::core {

/// The shapelets for partial overlaps of their first samples (prefix), or of their last samples in reverse (suffix).
struct OverlapSide {
  Eigen::MatrixXf values;  ///< [kGroup, M G]: values, group g from column M g on, from the end that always overlaps
  Eigen::MatrixXf within;  ///< [kGroup, M G]: sum of the first L values at column M g + L
  Eigen::MatrixXf energy;  ///< [kGroup, M G]: part of the energy in the first L values at column M g + L
  std::vector<tile::Energies> energies;  ///< [kGroup G]
};

/// The shapelets of one set in G groups of tile::kGroup. Zeros fill the last group.
struct PreparedShapelets {
  explicit PreparedShapelets(const Eigen::Ref<const Eigen::MatrixXf>& normalised);

  int length;
  int groups;
  int block;  ///< overlaps in a block
  std::vector<bool> constant;
  OverlapSide prefix;
  OverlapSide suffix;
};

/// A stretch of windows on values centred on their own mean. Positions count from the first window of the stretch.
class PreparedWindows {
 public:
  /// Replaces the present windows by those of `stretch`; `block` is PreparedShapelets::block. Keeps its memory.
  void Prepare(const tile::Loops& loops, const WindowSet& windows, const WindowStretch& stretch, int block,
               bool with_bounds);

  int first() const { return first_; }
  int count() const { return count_; }
  /// Number of tiles that hold the positions of all windows.
  int full_tiles() const { return (count_ + tile_ - 1) / tile_; }
  /// Number of tiles on either side of these that partial overlaps reach.
  int further_tiles() const { return further_tiles_; }
  /// Number of all tiles. Arrays by tile begin with those before position 0.
  int all_tiles() const { return full_tiles() + 2 * further_tiles_; }
  /// Windows that need double precision, by their index in the WindowSet.
  const std::vector<int>& hard() const { return hard_; }

  const float* series() const { return Column(kSeries); }
  const float* mean() const { return Column(kMean); }
  const float* spread() const { return Column(kSpread); }
  const float* scale() const { return Column(kScale); }
  /// Bounds by tile for the overlaps of `direction`, 1 or -1; null if Prepare() made none.
  const tile::Bounds* bounds(int direction) const {
    return bounds_.empty() ? nullptr : bounds_.data() + further_tiles_ + (direction > 0 ? 0 : all_tiles());
  }

 private:
  /// Columns by position or window. Those from kHeads on are the scratch that FillBounds() needs.
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
  /// Fills a column before its first value with `before`, and from its `count`-th value on with `behind`.
  void SetMargins(int column, int count, float before, float behind);
  void FillSeries(const WindowSet& windows);
  void FillWindows(const tile::Loops& loops, const WindowSet& windows);
  void FillBounds(const tile::Loops& loops, int block);

  int length_ = 0;
  int first_ = 0;
  int count_ = 0;
  int tile_ = 1;
  int further_tiles_ = 0;
  int margin_ = 0;  ///< floats on either side of a column that loops may read
  int stride_ = 0;  ///< floats from one column to the next
  double centre_ = 0.0;
  std::vector<float> values_;  ///< all columns, each with a margin on both sides
  std::vector<tile::Bounds> bounds_;
  std::vector<int> hard_;
};

/// The arrays that a search writes to.
struct SearchMemory::Arrays {
  PreparedWindows windows;
  std::vector<float> sums;     ///< FullArguments::sums
  std::vector<float> largest;  ///< FullArguments::largest
};

}  // namespace contact_shapelets::core
