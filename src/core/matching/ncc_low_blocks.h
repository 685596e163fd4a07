#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "core/matching/ncc_definition.h"
#include "core/matching/ncc_search.h"
#include "core/matching/ncc_tile.h"

/// \file
/// Searches of one series by shapelets that change little from one search to the next.
///
/// By Cauchy and Schwarz no normalised cross-correlation changes by more than |s_now - s_then| / sqrt(M) while a
/// shapelet goes from s_then to s_now, both z-normalised. A search therefore notes which blocks of partial overlaps are
/// low, that is, lag behind the best match; they are left out as long as the shapelet has moved too little for them to
/// catch up.

namespace contact_shapelets::core {

/// How far shapelets have moved since earlier steps.
class ShapeletHistory {
 public:
  /// Takes the shapelets of the next step, as many and as long as those before.
  void Add(const ShapeletSet& shapelets);

  /// The step that was added last, from 0 on.
  int step() const { return step_; }
  /// What a normalised cross-correlation with shapelet k has changed by since `step` at the most; more than any can
  /// where that step is not known any more, or is -1.
  float Moved(int step, int k) const;

 private:
  /// Steps that are known. Since earlier ones shapelets have moved too far for their blocks to be low still.
  static constexpr std::size_t kSteps = 16;

  int step_ = -1;
  std::deque<Eigen::MatrixXf> shapelets_;  ///< z-normalised [M, K], the last step first
  std::deque<Eigen::VectorXf> moved_;      ///< since each of these, by shapelet
};

/// What searches of one series have noted.
struct LowBlocks {
  struct Noted {
    int step = -1;         ///< of the search in which a shapelet's low blocks were noted; -1 where none was
    float most = 0.0F;     ///< the largest value that these can have had
    bool renewed = false;  ///< by the search that is under way
  };
  std::vector<Noted> noted;  ///< by shapelet
  /// By stretch, group, direction and tile, interleaved as in tile::PartialArguments.
  std::vector<tile::BlockBits> blocks;
};

/// FindBestMatchesWith() in a series of which earlier searches have left `low_blocks`, none before the first: all with
/// the same windows, loops and pruning, and with the shapelets of `history`, which ends with `shapelets`. Their last
/// `matches` are the hints. The new ones are those of FindBestMatchesWith() to the last bit.
void FindBestMatchesAgain(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                          Pruning pruning, const ShapeletHistory& history, SearchMemory* memory, LowBlocks* low_blocks,
                          std::vector<Match>* matches);

/// The same with the loops and the pruning of FindBestMatches().
void FindBestMatchesAgain(const WindowSet& windows, const ShapeletSet& shapelets, const ShapeletHistory& history,
                          LowBlocks* low_blocks, std::vector<Match>* matches);

}  // namespace contact_shapelets::core
