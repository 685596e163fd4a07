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
  Eigen::MatrixXf energy;  ///< [kGroup, B G]: by block of overlaps, the energy within its largest one, [0, 1]
};

/// What PreparedShapelets has of the shapelets of one set, in G groups of tile::kGroup; zeros fill the last one.
struct PreparedShapelets {
  explicit PreparedShapelets(const Eigen::Ref<const Eigen::MatrixXf>& normalised);

  int length;
  int groups;
  int block;   ///< overlaps in a block
  int blocks;  ///< B, blocks in the M - 1 partial overlaps
  std::vector<bool> constant;
  OverlapSide prefix;
  OverlapSide suffix;
};

/// A stretch of windows, on values centred on their own mean; positions are counted from the first window of the stretch.
class PreparedWindows {
 public:
  /// Takes `count` windows from `first` on.
  PreparedWindows(const tile::Loops& loops, const WindowSet& windows, int first, int count, int block, int blocks,
                  bool prune);

  int first() const { return first_; }
  int count() const { return count_; }
  /// Tiles that hold the positions of all windows.
  int full_tiles() const { return (count_ + tile_ - 1) / tile_; }
  /// Tiles that hold the positions beyond these, on either side, that partial overlaps reach.
  int further_tiles() const { return further_tiles_; }
  /// Windows too close to their rounding for single precision, counted from the first one of the set.
  const std::vector<int>& hard() const { return hard_; }

  const float* series() const { return series_.data() + margin_; }
  const float* mean() const { return mean_.data() + margin_; }
  const float* spread() const { return spread_.data() + margin_; }
  const float* scale() const { return scale_.data() + margin_; }
  const float* prefix_bounds() const { return prefix_bounds_.data() + further_tiles_ * blocks_; }
  const float* suffix_bounds() const { return suffix_bounds_.data() + further_tiles_ * blocks_; }

 private:
  void FillWindows(const WindowSet& windows);
  void FillBounds(const tile::Loops& loops, const WindowSet& windows, bool prune);
  void FillBlock(int block, const Eigen::Ref<const Eigen::ArrayXf>& prefix, const Eigen::Ref<const Eigen::ArrayXf>& suffix);

  int length_;
  int first_;
  int count_;
  int tile_;
  int further_tiles_;
  int margin_;  ///< what positions may jut out
  int block_;
  int blocks_;
  Eigen::ArrayXf series_;
  Eigen::ArrayXf mean_;
  Eigen::ArrayXf spread_;
  Eigen::ArrayXf scale_;
  Eigen::ArrayXd sums_;     ///< of the centred values
  Eigen::ArrayXd squares_;
  Eigen::ArrayXf prefix_bounds_;  ///< by tile and block
  Eigen::ArrayXf suffix_bounds_;
  std::vector<int> hard_;
};

}  // namespace contact_shapelets::core
