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

/// Columns of PreparedWindows beside those that have a function: sums before a sample, and scratch.
constexpr int kSums = 4;
constexpr int kSquares = 5;
constexpr int kHeads = 6;
constexpr int kTails = 7;
constexpr int kEnergyScale = 8;
constexpr int kBeforeWindow = 9;
constexpr int kToWindowEnd = 10;
constexpr int kColumns = 11;

/// Overlaps in a block. More blocks have closer bounds, and take longer to look at; there are tile::kBlocks at the
/// most.
int BlockSize(int length) { return std::max(std::clamp(length / 8, 4, 8), (length - 2) / tile::kBlocks + 1); }

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
      block_(block),
      values_(Eigen::ArrayXXf::Zero(count + length_ - 1 + 2 * margin_, kColumns)),
      bounds_(static_cast<std::size_t>(2 * all_tiles())) {
  FillSeries(windows);
  FillWindows(loops, windows);
  FillBounds(loops, prune);
}

void PreparedWindows::FillSeries(const WindowSet& windows) {
  const int samples = count_ + length_ - 1;
  const auto part = windows.series().segment(first_, samples);
  centre_ = part.cast<double>().mean();
  float* series = Column(0);
  float* sums = Column(kSums);
  float* squares = Column(kSquares);
  double sum = 0.0;
  double square = 0.0;
  for (int q = 0; q < samples; ++q) {
    const double value = static_cast<double>(part[q]) - centre_;
    series[q] = static_cast<float>(value);
    sum += value;
    square += value * value;
    sums[q + 1] = static_cast<float>(sum);
    squares[q + 1] = static_cast<float>(square);
  }
  values_.col(kSums).tail(margin_ - 1).setConstant(static_cast<float>(sum));
  values_.col(kSquares).tail(margin_ - 1).setConstant(static_cast<float>(square));
}

void PreparedWindows::FillWindows(const tile::Loops& loops, const WindowSet& windows) {
  values_.col(2).setConstant(kNever);
  tile::WindowArguments arguments{};
  arguments.mean = windows.mean().data() + first_;
  arguments.inverse = windows.inverse_deviation().data() + first_;
  arguments.squares = Column(kSquares);
  arguments.centre = centre_;
  arguments.hard_ratio = kHardRatio * kHardRatio;
  arguments.length = length_;
  arguments.count = count_;
  arguments.centred_mean = Column(1);
  arguments.spread = Column(2);
  arguments.scale = Column(3);
  if (loops.window_values(arguments) == 0) return;
  for (int j = 0; j < count_; ++j) {
    if (scale()[j] == 0.0F && !windows.IsFlat(first_ + j)) hard_.push_back(first_ + j);
  }
}

void PreparedWindows::FillBounds(const tile::Loops& loops, bool prune) {
  // The sums are rounded to 6e-8 of themselves. By Cauchy and Schwarz, a product of a mean and a sum is under the
  // squares' sum times the root of how often the window fits.
  const float squares = values_(values_.rows() - 1, kSquares);
  tile::BoundArguments arguments{};
  arguments.sums = Column(kSums);
  arguments.squares = Column(kSquares);
  arguments.mean = mean();
  arguments.scale = scale();
  arguments.rounding = 2e-6F * squares * std::sqrt(1.0F + static_cast<float>(count_) / static_cast<float>(length_));
  arguments.unbounded = prune ? 0.0F : kUnbounded;
  arguments.length = length_;
  arguments.block = block_;
  arguments.count = count_;
  arguments.further_tiles = further_tiles_;
  arguments.tiles = all_tiles();
  arguments.heads = Column(kHeads);
  arguments.tails = Column(kTails);
  arguments.energy_scale = Column(kEnergyScale);
  arguments.before_window = Column(kBeforeWindow);
  arguments.to_window_end = Column(kToWindowEnd);
  arguments.prefix = bounds_.data();
  arguments.suffix = bounds_.data() + all_tiles();
  loops.all_bounds(arguments);
}

}  // namespace contact_shapelets::core
