#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "core/matching/ncc_definition.h"
#include "core/matching/ncc_search.h"
#include "core/matching/ncc_tile.h"

/// \file
/// Repeated searches of one series by shapelets that change little from one search to the next.
///
/// If a shapelet moves from s_then to s_now, both z-normalised, no normalised cross-correlation changes by more than
/// |s_now - s_then| / sqrt(M) (Cauchy and Schwarz). A search notes which blocks of partial overlaps are low: all their
/// values lag behind the best match. Later searches skip low blocks until the shapelet has moved so far that a low
/// value could have caught up.

namespace contact_shapelets::core {

/// How far shapelets have moved since earlier steps.
class ShapeletHistory {
 public:
  /// Adds the shapelets of the next step, as many and as long as those before.
  void Add(const ShapeletSet& shapelets);

  /// The last step added, counted from 0; -1 before the first.
  int step() const { return step_; }
  /// Returns a bound on the change of a normalised cross-correlation with shapelet k since `step`. If the history no
  /// longer holds that step, or `step` is -1, returns more than any such change.
  float Moved(int step, int k) const;

 private:
  /// Steps kept. Blocks noted before them are no longer low, because the shapelets have moved too far.
  static constexpr std::size_t kSteps = 16;

  int step_ = -1;
  std::deque<Eigen::MatrixXf> shapelets_;  ///< z-normalised [M, K], the last step first
  std::deque<Eigen::VectorXf> moved_;      ///< Moved() since each of these steps, by shapelet [K]
};

/// The low blocks that earlier searches of one series noted.
struct LowBlocks {
  struct Noted {
    int step = -1;         ///< step of the search that noted the shapelet's low blocks; -1 if none has
    float most = 0.0F;     ///< upper bound on the values in these blocks at that step
    bool renewed = false;  ///< whether the present search notes them anew
  };
  std::vector<Noted> noted;  ///< by shapelet
  /// By stretch, group, direction and tile, interleaved as in tile::PartialArguments.
  std::vector<tile::BlockBits> blocks;
};

/// Searches a series again, as FindBestMatchesWith() does, but skips low blocks. The matches are the same to the last
/// bit.
///
/// `low_blocks` are those of the earlier searches of this series, empty before the first. All these searches must have
/// the same windows, loops and pruning, and the shapelets of `history`, which ends with `shapelets`. `matches` holds
/// the matches of the last search, which serve as hints, and receives the new ones.
void FindBestMatchesAgain(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                          Pruning pruning, const ShapeletHistory& history, SearchMemory* memory, LowBlocks* low_blocks,
                          std::vector<Match>* matches);

/// The same with the loops and the pruning of FindBestMatches().
void FindBestMatchesAgain(const WindowSet& windows, const ShapeletSet& shapelets, const ShapeletHistory& history,
                          LowBlocks* low_blocks, std::vector<Match>* matches);

}  // namespace contact_shapelets::core
