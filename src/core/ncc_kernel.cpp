#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "contact_shapelets/core/ncc.h"
#include "core/ncc_search.h"
#include "core/ncc_tile.h"

namespace contact_shapelets::core {
namespace {

using tile::kGroup;
using tile::kPadding;

/// By Cauchy and Schwarz the rounding of a sum in single precision is at most some 6e-8 of the norm of the values near a
/// window; where that is too much for the window's deviation, the window is summed up in double precision.
constexpr double kHardRatio = 150.0;
/// How far below the best a bound must be to prune, so that rounding of the bound never does.
constexpr float kPruneMargin = 2e-6F;

/// CC_w of one window, by the definition, in double precision.
double Evaluate(const WindowSet& windows, const float* shapelet, int window, int shift) {
  const int length = windows.length();
  const float* series = windows.series().data() + window;
  const double mean = windows.mean()[window];
  double sum = 0.0;
  for (int m = std::max(0, -shift); m < std::min(length, length - shift); ++m) {
    sum += static_cast<double>(shapelet[m]) * (static_cast<double>(series[m + shift]) - mean);
  }
  return sum * windows.inverse_deviation()[window] / length;
}

/// The shapelets in groups, with what bounds a partial overlap.
class Groups {
 public:
  explicit Groups(const ShapeletSet& shapelets)
      : length_(shapelets.length()),
        count_((shapelets.count() + kGroup - 1) / kGroup),
        values_(static_cast<std::size_t>(count_ * kGroup * length_), 0.0F),
        sums_(shapelets.count(), std::vector<float>(length_ + 1, 0.0F)),
        energies_(sums_) {
    for (int k = 0; k < shapelets.count(); ++k) {
      double sum = 0.0;
      double energy = 0.0;
      for (int m = 0; m < length_; ++m) {
        const float value = shapelets.normalised()(m, k);
        values_[static_cast<std::size_t>(((k / kGroup) * length_ + m) * kGroup + k % kGroup)] = value;
        sums_[k][m + 1] = static_cast<float>(sum += value);
        energies_[k][m + 1] = static_cast<float>((energy += static_cast<double>(value) * value) / length_);
      }
    }
  }

  int count() const { return count_; }
  /// True where the shapelet was constant, and matches nothing.
  bool IsConstant(int k) const { return energies_[k][length_] == 0.0F; }
  const float* values(int group) const { return values_.data() + static_cast<std::size_t>(group * kGroup * length_); }
  /// Sum of the first `samples` values of shapelet k.
  float Sum(int k, int samples) const { return sums_[k][samples]; }

  /// How many overlaps, from M - 1 samples downward, can still exceed `best`: by Cauchy and Schwarz |CC| at an overlap is at
  /// most the square root of the part of the shapelet's energy within it.
  int UsefulPrefixes(int k, float best) const {
    const float least = (best - kPruneMargin) * std::abs(best - kPruneMargin);
    int overlap = length_ - 1;
    while (overlap > 0 && energies_[k][overlap] > least) --overlap;
    return length_ - 1 - overlap;
  }
  int UsefulSuffixes(int k, float best) const {
    const float least = (best - kPruneMargin) * std::abs(best - kPruneMargin);
    int overlap = length_ - 1;
    while (overlap > 0 && energies_[k][length_] - energies_[k][length_ - overlap] > least) --overlap;
    return length_ - 1 - overlap;
  }

 private:
  int length_;
  int count_;
  std::vector<float> values_;
  std::vector<std::vector<float>> sums_;
  std::vector<std::vector<float>> energies_;
};

/// The search in a stretch of windows: single precision on values centred on their own mean.
class BlockSearch {
 public:
  BlockSearch(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets, const Groups& groups, int first, int count,
              std::vector<Match>* matches)
      : loops_(loops),
        windows_(windows),
        shapelets_(shapelets),
        groups_(groups),
        length_(windows.length()),
        first_(first),
        count_(count),
        margin_(length_ + kPadding),
        stride_(count + 2 * margin_ + kPadding),
        series_(static_cast<std::size_t>(stride_ + length_ + kPadding), 0.0F),
        scale_(static_cast<std::size_t>(stride_), 0.0F),
        offset_(static_cast<std::size_t>(stride_), 0.0F),
        sums_(static_cast<std::size_t>(stride_) * kGroup * groups.count(), 0.0F),
        greatest_(static_cast<std::size_t>(stride_) * kGroup, 0.0F),
        matches_(*matches) {
    Prepare();
  }

  void Run(bool prune) {
    for (int group = 0; group < groups_.count(); ++group) {
      loops_.full_overlap(series_.data() + margin_, groups_.values(group), length_, count_, stride_,
                                     SumsOf(group) + margin_);
    }
    for (int k = 0; k < shapelets_.count(); ++k) TakeFullOverlaps(k);
    for (int k = 0; k < shapelets_.count(); ++k) {
      for (const int window : hard_) SearchInDouble(k, window);
    }
    for (int group = 0; group < groups_.count(); ++group) SearchPartialOverlaps(group, prune);
  }

 private:
  void Prepare() {
    const Eigen::VectorXd part = windows_.series().segment(first_, count_ + length_ - 1).cast<double>();
    const double centre = part.mean();
    for (Eigen::Index q = 0; q < part.size(); ++q) series_[margin_ + q] = static_cast<float>(part[q] - centre);
    Eigen::VectorXd energy(part.size() + 1);
    energy[0] = 0.0;
    for (Eigen::Index q = 0; q < part.size(); ++q) energy[q + 1] = energy[q] + (part[q] - centre) * (part[q] - centre);
    for (int j = 0; j < count_; ++j) {
      const double inverse = windows_.inverse_deviation()[first_ + j];
      // All values that a sum at a position near this window can hold.
      const Eigen::Index begin = std::max(0, j - length_);
      const Eigen::Index end = std::min<Eigen::Index>(part.size(), j + 2 * length_);
      if (inverse * std::sqrt(energy[end] - energy[begin]) > kHardRatio) {
        hard_.push_back(first_ + j);
        continue;
      }
      scale_[margin_ + j] = static_cast<float>(inverse / length_);
      offset_[margin_ + j] = static_cast<float>((windows_.mean()[first_ + j] - centre) * inverse / length_);
    }
  }

  float* SumsOf(int group) { return sums_.data() + static_cast<std::size_t>(group) * kGroup * stride_; }

  const float* Shapelet(int k) const { return shapelets_.normalised().col(k).data(); }

  void Offer(int k, int window, int shift) {
    if (groups_.IsConstant(k)) return;
    const auto value = static_cast<float>(Evaluate(windows_, Shapelet(k), window, shift));
    if (value <= matches_[k].similarity) return;
    matches_[k] = {value, window, shift};
  }

  void TakeFullOverlaps(int k) {
    const float* sums = SumsOf(k / kGroup) + (k % kGroup) * stride_ + margin_;
    const Eigen::Map<const Eigen::ArrayXf> values(sums, count_);
    const Eigen::Map<const Eigen::ArrayXf> scale(scale_.data() + margin_, count_);
    Eigen::Index window = 0;
    const float greatest = (values * scale).maxCoeff(&window);
    if (greatest > 0.0F) Offer(k, first_ + static_cast<int>(window), 0);
  }

  void SearchInDouble(int k, int window) {
    const int prefixes = groups_.UsefulPrefixes(k, matches_[k].similarity);
    const int suffixes = groups_.UsefulSuffixes(k, matches_[k].similarity);
    for (int shift = -suffixes; shift <= prefixes; ++shift) Offer(k, window, shift);
  }

  void SearchPartialOverlaps(int group, bool prune) {
    int prefixes = 0;
    int suffixes = 0;
    const int end = std::min((group + 1) * kGroup, shapelets_.count());
    for (int k = group * kGroup; k < end; ++k) {
      prefixes = std::max(prefixes, prune ? groups_.UsefulPrefixes(k, matches_[k].similarity) : length_ - 1);
      suffixes = std::max(suffixes, prune ? groups_.UsefulSuffixes(k, matches_[k].similarity) : length_ - 1);
    }
    ExtendSums(group, suffixes, prefixes);
    // Prefixes: the shapelet's end leaves, and the window begins before it. Suffixes the other way about.
    Search(group, 1, prefixes);
    Search(group, -1, suffixes);
  }

  /// Full overlaps at the positions where the shapelet juts out of the first or the last window.
  void ExtendSums(int group, int before, int behind) {
    float* sums = SumsOf(group);
    Extra(group, margin_ - before, before, sums);
    Extra(group, margin_ + count_, behind, sums);
  }

  void Extra(int group, int begin, int count, float* sums) {
    std::vector<float> extra(static_cast<std::size_t>(kGroup) * (count + kPadding));
    loops_.full_overlap(series_.data() + begin, groups_.values(group), length_, count, count + kPadding,
                                   extra.data());
    for (int i = 0; i < kGroup; ++i) {
      std::copy_n(extra.data() + i * (count + kPadding), count, sums + i * stride_ + begin);
    }
  }

  /// `side` is 1 for prefixes (w > 0) and -1 for suffixes (w < 0).
  void Search(int group, int side, int steps) {
    if (steps == 0) return;
    std::vector<float> within(static_cast<std::size_t>(kGroup) * steps, 0.0F);
    const int end = std::min((group + 1) * kGroup, shapelets_.count());
    for (int k = group * kGroup; k < end; ++k) {
      for (int n = 0; n < steps; ++n) {
        const float total = groups_.Sum(k, length_);
        within[kGroup * n + k % kGroup] =
            side > 0 ? groups_.Sum(k, length_ - 1 - n) : total - groups_.Sum(k, n + 1);
      }
    }
    std::fill(greatest_.begin(), greatest_.end(), 0.0F);
    const int begin = side > 0 ? 1 : -steps;
    const int positions = count_ - 1 + steps;
    tile::PartialArguments arguments{};
    arguments.series = series_.data() + margin_;
    arguments.shapelets = groups_.values(group);
    arguments.within = within.data();
    arguments.scale = scale_.data() + margin_;
    arguments.offset = offset_.data() + margin_;
    arguments.sums = SumsOf(group) + margin_;
    arguments.greatest = greatest_.data() + margin_;
    arguments.first = side > 0 ? length_ - 1 : 0;
    arguments.direction = -side;
    arguments.window = -side;
    arguments.steps = steps;
    arguments.begin = begin;
    arguments.count = positions;
    arguments.stride = stride_;
    loops_.partial_overlaps(arguments);
    for (int k = group * kGroup; k < end; ++k) TakePartialOverlaps(k, side, steps, begin, positions);
  }

  void TakePartialOverlaps(int k, int side, int steps, int begin, int positions) {
    const Eigen::Map<const Eigen::ArrayXf> greatest(greatest_.data() + (k % kGroup) * stride_ + margin_ + begin,
                                                    positions);
    Eigen::Index best = 0;
    if (greatest.maxCoeff(&best) <= matches_[k].similarity) return;
    const int position = first_ + begin + static_cast<int>(best);
    for (int shift = 1; shift <= steps; ++shift) {
      const int window = position - side * shift;
      if (window < first_ || window >= first_ + count_ || windows_.IsFlat(window)) continue;
      Offer(k, window, side * shift);
    }
  }

  const tile::Loops& loops_;
  const WindowSet& windows_;
  const ShapeletSet& shapelets_;
  const Groups& groups_;
  int length_;
  int first_;
  int count_;
  int margin_;  ///< what positions may jut out, zeros
  int stride_;
  std::vector<float> series_;
  std::vector<float> scale_;
  std::vector<float> offset_;
  std::vector<float> sums_;
  std::vector<float> greatest_;
  std::vector<int> hard_;
  std::vector<Match>& matches_;
};

}  // namespace

void FindBestMatchesWith(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                         const std::vector<Match>& hints, const MatchOptions& options, std::vector<Match>* matches) {
  const int length = windows.length();
  if (length != shapelets.length()) throw std::invalid_argument("windows and shapelets differ in length");
  if (!hints.empty() && static_cast<int>(hints.size()) != shapelets.count()) {
    throw std::invalid_argument("there must be one hint for each shapelet, or none");
  }
  const Groups groups(shapelets);
  std::vector<Match> found(static_cast<std::size_t>(shapelets.count()));
  for (int k = 0; k < static_cast<int>(hints.size()); ++k) {
    const Match& hint = hints[k];
    if (hint.window < 0 || groups.IsConstant(k) || windows.IsFlat(hint.window)) continue;
    found[k] = hint;
    found[k].similarity =
        static_cast<float>(Evaluate(windows, shapelets.normalised().col(k).data(), hint.window, hint.shift));
  }
  const int block = std::max(1024, 4 * length);
  for (int first = 0; first < windows.window_count() && windows.usable_window_count() > 0; first += block) {
    const int count = std::min(block, windows.window_count() - first);
    BlockSearch(loops, windows, shapelets, groups, first, count, &found).Run(options.prune);
  }
  *matches = std::move(found);
}

}  // namespace contact_shapelets::core
