#include "core/ncc_prepared.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {
namespace {

using tile::kGroup;
using tile::kPadding;

/// By Cauchy and Schwarz the rounding of a sum in single precision is at most some 6e-8 of the norm of the values near
/// a window; where that is too much for the window's deviation, the window is summed up in double precision.
constexpr double kHardRatio = 150.0;
/// M sigma of a window that does not count: no sum exceeds it.
constexpr float kNever = 1e30F;
/// A bound that prunes nothing.
constexpr float kUnbounded = 8.0F;

/// The largest of neighbouring values, in a few steps whatever their number; values beyond the ends are 0.
class SlidingMaxima {
 public:
  SlidingMaxima(int count, int margin) : count_(count), margin_(margin), maxima_(count + 2 * margin) {
    maxima_.setZero();
  }

  /// Where `count` values are to be written before Slide().
  float* values() { return maxima_.data() + margin_; }
  /// Turns each value into the largest of itself and the kSpan - 1 behind it.
  void Slide() {
    std::fill_n(values() + count_, kSpan, 0.0F);
    maxima_.segment(margin_ - kSpan, kSpan).setZero();
    const Eigen::Index first = margin_ - kSpan;
    const Eigen::Index size = count_ + kSpan;
    for (int step = 1; step < kSpan; step *= 2) {
      maxima_.segment(first, size) = maxima_.segment(first, size).max(maxima_.segment(first + step, size));
    }
  }
  /// The largest value of `count` >= kSpan ones from `first` on, these no farther than the margin from the ends.
  float Largest(int first, int count) const {
    const float* from = maxima_.data() + margin_ + first;
    float largest = from[count - kSpan];
    for (int at = 0; at < count - kSpan; at += kSpan) largest = std::max(largest, from[at]);
    return largest;
  }

 private:
  static constexpr int kSpan = 8;

  int count_;
  int margin_;
  Eigen::ArrayXf maxima_;
};

/// Overlaps in a block. More blocks have closer bounds, and take longer to look at; there are tile::kBlocks at the
/// most.
int BlockSize(int length) { return std::max(std::clamp(length / 8, 2, 8), (length - 2) / tile::kBlocks + 1); }

OverlapSide SideOf(const PreparedShapelets& prepared, const Eigen::Ref<const Eigen::MatrixXf>& normalised,
                   bool reverse) {
  const int length = prepared.length;
  OverlapSide side;
  side.values = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
  side.within = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
  side.energies.resize(static_cast<std::size_t>(kGroup * prepared.groups));
  for (Eigen::Index k = 0; k < normalised.cols(); ++k) {
    const Eigen::Index row = k % kGroup;
    const Eigen::Index group = k / kGroup;
    double sum = 0.0;
    double energy = 0.0;
    for (int m = 0; m < length; ++m) {
      const float value = normalised(reverse ? length - 1 - m : m, k);
      side.values(row, length * group + m) = value;
      side.within(row, length * group + m) = static_cast<float>(sum);
      sum += value;
      energy += static_cast<double>(value) * value;
      if (m + 1 == length) break;
      tile::Energies& energies = side.energies[static_cast<std::size_t>(k)];
      energies.head[m / prepared.block] = static_cast<float>(energy / length);
      if (m % prepared.block == 0) {
        energies.tail[m / prepared.block] = static_cast<float>(std::max(0.0, 1.0 - energy / length));
      }
    }
  }
  return side;
}

}  // namespace

PreparedShapelets::PreparedShapelets(const Eigen::Ref<const Eigen::MatrixXf>& normalised)
    : length(static_cast<int>(normalised.rows())),
      groups((static_cast<int>(normalised.cols()) + kGroup - 1) / kGroup),
      block(BlockSize(length)) {
  for (Eigen::Index k = 0; k < normalised.cols(); ++k) constant.push_back(normalised.col(k).isZero(0.0F));
  prefix = SideOf(*this, normalised, false);
  suffix = SideOf(*this, normalised, true);
}

PreparedWindows::PreparedWindows(const tile::Loops& loops, const WindowSet& windows, int first, int count, int block,
                                 bool prune)
    : length_(windows.length()),
      first_(first),
      count_(count),
      tile_(loops.positions),
      further_tiles_((length_ - 1 + tile_ - 1) / tile_),
      margin_(length_ + 2 * kPadding),
      block_(block) {
  FillWindows(windows);
  FillBounds(loops, prune);
}

void PreparedWindows::FillWindows(const WindowSet& windows) {
  const int samples = count_ + length_ - 1;
  const int size = samples + 2 * margin_;
  const Eigen::ArrayXd part = windows.series().segment(first_, samples).cast<double>();
  const double centre = part.mean();
  series_.setZero(size);
  series_.segment(margin_, samples) = (part - centre).cast<float>();
  sums_.setZero(size);
  squares_.setZero(size);
  double sum = 0.0;
  double square = 0.0;
  for (int q = 0; q < samples; ++q) {
    const double value = part[q] - centre;
    sum += value;
    square += value * value;
    sums_[margin_ + q + 1] = static_cast<float>(sum);
    squares_[margin_ + q + 1] = static_cast<float>(square);
  }
  sums_.tail(margin_ - 1).setConstant(static_cast<float>(sum));
  squares_.tail(margin_ - 1).setConstant(static_cast<float>(square));

  mean_.setZero(size);
  spread_.setConstant(size, kNever);
  scale_.setZero(size);
  for (int j = 0; j < count_; ++j) {
    const double inverse = windows.inverse_deviation()[first_ + j];
    if (inverse == 0.0) continue;
    // All values that a sum at a position near this window can hold.
    const int begin = std::max(0, j - length_);
    const int end = std::min(samples, j + 2 * length_);
    if (inverse * inverse * (squares_[margin_ + end] - squares_[margin_ + begin]) > kHardRatio * kHardRatio) {
      hard_.push_back(first_ + j);
      continue;
    }
    mean_[margin_ + j] = static_cast<float>(windows.mean()[first_ + j] - centre);
    spread_[margin_ + j] = static_cast<float>(length_ / inverse);
    scale_[margin_ + j] = static_cast<float>(inverse / length_);
  }
}

void PreparedWindows::FillBounds(const tile::Loops& loops, bool prune) {
  const int tiles = full_tiles() + 2 * further_tiles_;
  const Eigen::ArrayXf energy_scale = scale_.square() * static_cast<float>(length_);
  // The sums are rounded to 6e-8 of themselves. By Cauchy and Schwarz, a product of a mean and a sum is under the
  // squares' sum times the root of how often the window fits.
  const float squares = squares_[squares_.size() - 1];
  const float rounding = 1e-6F * squares * std::sqrt(1.0F + static_cast<float>(count_) / static_cast<float>(length_));
  tile::EnergyArguments arguments{
      sums_.data() + margin_, squares_.data() + margin_, mean(), energy_scale.data() + margin_, rounding, 0, 0, count_};
  SlidingMaxima scales(count_, margin_);
  std::copy_n(this->scale(), count_, scales.values());
  scales.Slide();
  SlidingMaxima heads(count_, margin_);
  SlidingMaxima tails(count_, margin_);
  const auto fill = [&](SlidingMaxima* maxima, int first, int samples) {
    if (prune) {
      arguments.first = first;
      arguments.samples = samples;
      loops.window_energies(arguments, maxima->values());
    } else {
      std::fill_n(maxima->values(), count_, kUnbounded);
    }
    maxima->Slide();
  };
  prefix_bounds_.resize(static_cast<std::size_t>(tiles));
  suffix_bounds_.resize(prefix_bounds_.size());
  for (int block = 0; block * block_ < length_ - 1; ++block) {
    const int least = block * block_ + 1;
    const int most = std::min((block + 1) * block_, length_ - 1);
    const int span = tile_ + most - least;
    const auto bound = [&](std::vector<tile::Bounds>* bounds, int from) {
      for (int tile = 0; tile < tiles; ++tile) {
        const int window = (tile - further_tiles_) * tile_ + from;
        tile::Bounds& entry = (*bounds)[static_cast<std::size_t>(tile)];
        entry.head[block] = heads.Largest(window, span);
        entry.tail[block] = tails.Largest(window, span);
        entry.scale[block] = scales.Largest(window, span);
      }
    };
    fill(&heads, length_ - most, most);
    fill(&tails, length_, length_ - least);
    bound(&prefix_bounds_, least - length_);
    fill(&heads, 0, most);
    fill(&tails, least - length_, length_ - least);
    bound(&suffix_bounds_, length_ - most);
  }
}

}  // namespace contact_shapelets::core
