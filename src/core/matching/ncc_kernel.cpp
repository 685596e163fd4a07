#include "core/matching/ncc_kernel.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "core/matching/ncc_low_blocks.h"
#include "core/matching/ncc_prepared.h"
#include "core/matching/ncc_search.h"
#include "core/matching/ncc_tile.h"

namespace contact_shapelets::core {
namespace {

using tile::kGroup;

/// A value must exceed the best one by this much, so that rounding does not pass for a better match.
constexpr float kMargin = 2e-6F;
/// Above every value.
constexpr float kBeyond = 2.0F;
/// Low values are at least this much below the best one. A greater lag makes fewer blocks low, and for longer.
constexpr float kLag = 0.08F;
/// Bound on the rounding error of low values in single precision, plus kMargin.
constexpr float kSlack = 5e-5F;
/// Least value of a lowered threshold: the loops need thresholds above 0.
constexpr float kLeast = 1e-3F;

void GrowTo(int size, std::vector<float>* values) {
  if (values->size() < static_cast<std::size_t>(size)) values->resize(static_cast<std::size_t>(size));
}

/// CC_w of one window by the definition, in double precision.
double Evaluate(const tile::Loops& loops, const WindowSet& windows, const float* shapelet, int window, int shift) {
  const int length = windows.length();
  const double sum =
      loops.correlation(shapelet + std::max(0, -shift), windows.series().data() + window + std::max(0, shift),
                        windows.mean()[window], length - std::abs(shift));
  return sum * windows.inverse_deviation()[window] / length;
}

/// Searches stretches of windows, one after the other.
class Search {
 public:
  Search(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets, SearchMemory::Arrays* memory,
         std::vector<Match>* matches)
      : loops_(loops),
        windows_(windows),
        shapelets_(shapelets),
        prepared_(shapelets.prepared()),
        memory_(*memory),
        matches_(*matches) {}

  /// Starts with the values of `hints`, which may be the matches that this search writes to.
  void TakeHints(const std::vector<Match>& hints) {
    for (int k = 0; k < static_cast<int>(hints.size()); ++k) {
      const Match hint = hints[k];
      matches_[k] = Match{};
      const bool possible = hint.window >= 0 && hint.window < windows_.window_count() &&
                            std::abs(hint.shift) < windows_.length() && !windows_.IsFlat(hint.window);
      if (possible) Offer(k, hint.window, hint.shift);
    }
  }

  /// Takes the low blocks of earlier searches. The hints decide which shapelets need theirs noted anew.
  void TakeLowBlocks(const ShapeletHistory& history, LowBlocks* low_blocks) {
    low_blocks_ = low_blocks;
    low_blocks->noted.resize(static_cast<std::size_t>(shapelets_.count()));
    for (int k = 0; k < shapelets_.count(); ++k) {
      LowBlocks::Noted& noted = low_blocks->noted[k];
      const float reached = noted.most + history.Moved(noted.step, k) + kSlack;
      noted.renewed = !prepared_.constant[k] && matches_[k].similarity < reached;
      if (noted.renewed) noted.step = history.step();
    }
  }

  /// Notes the bound on the low values of this search: its last threshold, because thresholds only rise.
  void FinishLowBlocks() {
    for (int k = 0; k < shapelets_.count(); ++k) {
      LowBlocks::Noted& noted = low_blocks_->noted[k];
      if (noted.renewed) noted.most = Lowered(Threshold(k));
    }
  }

  void Run(const WindowStretch& stretch, Pruning pruning) {
    PreparedWindows& block = memory_.windows;
    block.Prepare(loops_, windows_, stretch, prepared_.block, pruning == Pruning::kByBounds);
    const int stride = block.full_tiles() * loops_.positions;
    GrowTo(kGroup * stride, &memory_.sums);
    GrowTo(kGroup * block.full_tiles(), &memory_.largest);
    for (int group = 0; group < prepared_.groups; ++group) {
      if (low_blocks_ != nullptr) TakeLowBlocksOf(group, block);
      TakeFullOverlaps(block, group, stride);
      for (int k = group * kGroup; k < std::min((group + 1) * kGroup, shapelets_.count()); ++k) {
        for (const int window : block.hard()) SearchInDouble(k, window);
      }
      TakePartialOverlaps(block, group, 1, stride, pruning);
      TakePartialOverlaps(block, group, -1, stride, pruning);
    }
  }

 private:
  void Offer(int k, int window, int shift) {
    if (prepared_.constant[k]) return;
    const auto value =
        static_cast<float>(Evaluate(loops_, windows_, shapelets_.normalised().col(k).data(), window, shift));
    if (value > matches_[k].similarity) matches_[k] = {value, window, shift};
  }

  /// The value that a better match of shapelet k must exceed. It is above 0, as the best match always is.
  float Threshold(int k) const {
    if (k >= shapelets_.count() || prepared_.constant[k]) return kBeyond;
    return std::max(0.0F, matches_[k].similarity) + kMargin;
  }

  /// Values up to this are low.
  static float Lowered(float threshold) { return std::min(threshold, std::max(kLeast, threshold - kLag)); }

  /// Takes the low blocks of a group in this stretch, and clears those that this search notes anew.
  void TakeLowBlocksOf(int group, const PreparedWindows& block) {
    const std::size_t size = static_cast<std::size_t>(kGroup) * block.all_tiles();
    std::vector<tile::BlockBits>& blocks = low_blocks_->blocks;
    if (blocks.size() < low_offset_ + 2 * size) blocks.resize(low_offset_ + 2 * size);
    tile::BlockBits* low = blocks.data() + low_offset_;
    low_offset_ += 2 * size;
    renewed_ = 0;
    for (int k = group * kGroup; k < std::min((group + 1) * kGroup, shapelets_.count()); ++k) {
      if (!low_blocks_->noted[k].renewed) continue;
      renewed_ |= 1U << (k % kGroup);
      for (std::size_t tile = k % kGroup; tile < 2 * size; tile += kGroup) low[tile] = 0;
    }
    low_of_prefixes_ = low + kGroup * block.further_tiles();
    low_of_suffixes_ = low_of_prefixes_ + size;
  }

  void TakeFullOverlaps(const PreparedWindows& block, int group, int stride) {
    tile::FullArguments arguments{};
    arguments.series = block.series();
    arguments.shapelets = prepared_.prefix.values.col(prepared_.length * group).data();
    arguments.scale = block.scale();
    arguments.sums = memory_.sums.data();
    arguments.largest = memory_.largest.data();
    arguments.with_largest = block.bounds(1) != nullptr;
    arguments.length = prepared_.length;
    arguments.count = block.full_tiles() * loops_.positions;
    arguments.stride = stride;
    tile::FullResult result;
    loops_.full_overlaps(arguments, &result);
    for (int i = 0; i < kGroup; ++i) {
      const int k = group * kGroup + i;
      if (result.most[i] > Threshold(k)) Offer(k, block.first() + result.position[i], 0);
    }
  }

  void SearchInDouble(int k, int window) {
    for (int shift = 1 - windows_.length(); shift < windows_.length(); ++shift) {
      const float best = Threshold(k);
      const OverlapSide& side = shift > 0 ? prepared_.prefix : prepared_.suffix;
      const int overlap = windows_.length() - std::abs(shift);
      if (shift != 0 && side.energies[k].head[(overlap - 1) / prepared_.block] <= best * best) continue;
      Offer(k, window, shift);
    }
  }

  /// `direction` is 1 for shifts w > 0 and -1 for w < 0.
  void TakePartialOverlaps(const PreparedWindows& block, int group, int direction, int stride, Pruning pruning) {
    const int length = prepared_.length;
    const OverlapSide& side = direction > 0 ? prepared_.prefix : prepared_.suffix;
    tile::PartialArguments arguments{};
    arguments.values = &side.values(0, length * group);
    arguments.within = &side.within(0, length * group);
    arguments.energy = &side.energy(0, length * group);
    arguments.energies = &side.energies[static_cast<std::size_t>(group * kGroup)];
    arguments.samples = block.series() + (direction > 0 ? 0 : length - 1);
    arguments.mean = block.mean() - direction * length;
    arguments.spread = block.spread() - direction * length;
    arguments.scale = block.scale() - direction * length;
    arguments.sums = memory_.sums.data();
    arguments.largest = memory_.largest.data();
    arguments.bounds = block.bounds(direction);
    arguments.prune = pruning != Pruning::kNone;
    arguments.length = length;
    arguments.block = prepared_.block;
    arguments.direction = direction;
    arguments.stride = stride;
    arguments.full_tiles = block.full_tiles();
    arguments.windows = block.count();
    const int k = group * kGroup;
    arguments.count = std::min(kGroup, shapelets_.count() - k);
    arguments.low = direction > 0 ? low_of_prefixes_ : low_of_suffixes_;
    arguments.renewed = renewed_;
    for (int i = 0; i < kGroup; ++i) SetThresholds(i, Threshold(k + i), &arguments);
    const int begin = direction > 0 ? 0 : -block.further_tiles();
    const int end = direction > 0 ? block.full_tiles() + block.further_tiles() : block.full_tiles();
    unsigned better = 0;
    for (int tile = loops_.find_better(arguments, begin, end, &better); tile < end;
         tile = loops_.find_better(arguments, tile + 1, end, &better)) {
      TakeTile(block, k, direction, tile, better, &arguments);
    }
  }

  static void SetThresholds(int i, float best, tile::PartialArguments* arguments) {
    arguments->best[i] = best;
    arguments->lowered[i] = (arguments->renewed >> i & 1U) != 0 ? Lowered(best) : best;
  }

  /// Takes the best values in a tile for the shapelets with a bit in `better`.
  void TakeTile(const PreparedWindows& block, int k, int direction, int tile, unsigned better,
                tile::PartialArguments* arguments) {
    for (int i = 0; i < kGroup; ++i) {
      if ((better >> i & 1U) == 0) continue;
      tile::TileResult result;
      loops_.most_in_tile(*arguments, i, tile, &result);
      if (result.value <= arguments->best[i]) continue;
      const int shift = direction * (prepared_.length - result.overlap);
      Offer(k + i, block.first() + result.position - shift, shift);
      SetThresholds(i, Threshold(k + i), arguments);
    }
  }

  const tile::Loops& loops_;
  const WindowSet& windows_;
  const ShapeletSet& shapelets_;
  const PreparedShapelets& prepared_;
  SearchMemory::Arrays& memory_;
  std::vector<Match>& matches_;
  LowBlocks* low_blocks_ = nullptr;             ///< null if this search neither knows nor notes low blocks
  std::size_t low_offset_ = 0;                  ///< where the next group begins in LowBlocks::blocks
  unsigned renewed_ = 0;                        ///< bits of the present group's shapelets that are noted anew
  tile::BlockBits* low_of_prefixes_ = nullptr;  ///< of the present group and stretch, w > 0
  tile::BlockBits* low_of_suffixes_ = nullptr;  ///< of the present group and stretch, w < 0
};

void CheckSizes(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints) {
  if (windows.length() != shapelets.length()) throw std::invalid_argument("windows and shapelets differ in length");
  if (!hints.empty() && static_cast<int>(hints.size()) != shapelets.count()) {
    throw std::invalid_argument("there must be one hint for each shapelet, or none");
  }
}

}  // namespace

void FindBestMatchesWith(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                         const std::vector<Match>& hints, Pruning pruning, SearchMemory* memory,
                         std::vector<Match>* matches) {
  CheckSizes(windows, shapelets, hints);
  if (hints.empty()) {
    matches->assign(static_cast<std::size_t>(shapelets.count()), Match{});
  } else {
    matches->resize(static_cast<std::size_t>(shapelets.count()));
  }
  Search search(loops, windows, shapelets, &memory->arrays(), matches);
  search.TakeHints(hints);
  for (const WindowStretch& stretch : windows.stretches()) search.Run(stretch, pruning);
}

void FindBestMatchesAgain(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                          Pruning pruning, const ShapeletHistory& history, SearchMemory* memory, LowBlocks* low_blocks,
                          std::vector<Match>* matches) {
  if (pruning != Pruning::kByBounds) {
    FindBestMatchesWith(loops, windows, shapelets, *matches, pruning, memory, matches);
    return;
  }
  CheckSizes(windows, shapelets, *matches);
  matches->resize(static_cast<std::size_t>(shapelets.count()));
  Search search(loops, windows, shapelets, &memory->arrays(), matches);
  search.TakeHints(*matches);
  search.TakeLowBlocks(history, low_blocks);
  for (const WindowStretch& stretch : windows.stretches()) search.Run(stretch, pruning);
  search.FinishLowBlocks();
}

}  // namespace contact_shapelets::core
