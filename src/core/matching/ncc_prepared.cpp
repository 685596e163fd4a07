#include "core/matching/ncc_prepared.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {
namespace {

using tile::kGroup;
using tile::kPadding;

/// A sum in single precision is rounded by at most some 6e-8 of the norm of the values near a window (Cauchy and
/// Schwarz). If that norm is this many times the window's deviation, the window is searched in double precision.
constexpr double kHardRatio = 150.0;

/// Overlaps in a block. More blocks give closer bounds but take longer to look at. There are at most tile::kBlocks.
int BlockSize(int length) { return std::max(std::clamp(length / 8, 4, 8), (length - 2) / tile::kBlocks + 1); }

OverlapSide SideOf(const PreparedShapelets& prepared, const Eigen::Ref<const Eigen::MatrixXf>& normalised,
                   bool reverse) {
  const int length = prepared.length;
  OverlapSide side;
  side.values = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
  side.within = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
  side.energy = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
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
      side.energy(row, length * group + m) = static_cast<float>(energy / length);
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

SearchMemory::SearchMemory() : arrays_(std::make_unique<Arrays>()) {}
SearchMemory::~SearchMemory() = default;
SearchMemory::SearchMemory(SearchMemory&&) noexcept = default;
SearchMemory& SearchMemory::operator=(SearchMemory&&) noexcept = default;

PreparedShapelets::PreparedShapelets(const Eigen::Ref<const Eigen::MatrixXf>& normalised)
    : length(static_cast<int>(normalised.rows())),
      groups((static_cast<int>(normalised.cols()) + kGroup - 1) / kGroup),
      block(BlockSize(length)) {
  for (Eigen::Index k = 0; k < normalised.cols(); ++k) constant.push_back(normalised.col(k).isZero(0.0F));
  prefix = SideOf(*this, normalised, false);
  suffix = SideOf(*this, normalised, true);
}

void PreparedWindows::Prepare(const tile::Loops& loops, const WindowSet& windows, const WindowStretch& stretch,
                              int block, bool with_bounds) {
  length_ = windows.length();
  first_ = stretch.first;
  count_ = stretch.count;
  tile_ = loops.positions;
  further_tiles_ = (length_ - 1 + tile_ - 1) / tile_;
  margin_ = length_ + kPadding;
  stride_ = count_ + length_ - 1 + 2 * margin_;
  const auto size = static_cast<std::size_t>(stride_) * (with_bounds ? kColumns : kColumnsWithoutBounds);
  if (values_.size() < size) values_.resize(size);
  hard_.clear();
  bounds_.clear();
  FillSeries(windows);
  FillWindows(loops, windows);
  if (with_bounds) FillBounds(loops, block);
}

void PreparedWindows::SetMargins(int column, int count, float before, float behind) {
  std::fill(Column(column) - margin_, Column(column), before);
  std::fill(Column(column) + count, Column(column) + stride_ - margin_, behind);
}

void PreparedWindows::FillSeries(const WindowSet& windows) {
  const int samples = count_ + length_ - 1;
  const auto part = windows.series().segment(first_, samples);
  centre_ = part.cast<double>().mean();
  float* series = Column(kSeries);
  float* sums = Column(kSums);
  float* squares = Column(kSquares);
  double sum = 0.0;
  double square = 0.0;
  for (int q = 0; q < samples; ++q) {
    const double value = static_cast<double>(part[q]) - centre_;
    series[q] = static_cast<float>(value);
    sums[q] = static_cast<float>(sum);
    squares[q] = static_cast<float>(square);
    sum += value;
    square += value * value;
  }
  SetMargins(kSeries, samples, 0.0F, 0.0F);
  SetMargins(kSums, samples, 0.0F, static_cast<float>(sum));
  SetMargins(kSquares, samples, 0.0F, static_cast<float>(square));
}

void PreparedWindows::FillWindows(const tile::Loops& loops, const WindowSet& windows) {
  SetMargins(kMean, count_, 0.0F, 0.0F);
  SetMargins(kSpread, count_, tile::kNever, tile::kNever);
  SetMargins(kScale, count_, 0.0F, 0.0F);
  tile::WindowArguments arguments{};
  arguments.mean = windows.mean().data() + first_;
  arguments.inverse = windows.inverse_deviation().data() + first_;
  arguments.squares = Column(kSquares);
  arguments.centre = centre_;
  arguments.hard_ratio = kHardRatio * kHardRatio;
  arguments.length = length_;
  arguments.count = count_;
  arguments.centred_mean = Column(kMean);
  arguments.spread = Column(kSpread);
  arguments.scale = Column(kScale);
  if (loops.window_values(arguments) == 0) return;
  for (int j = 0; j < count_; ++j) {
    if (scale()[j] == 0.0F && !windows.IsFlat(first_ + j)) hard_.push_back(first_ + j);
  }
}

void PreparedWindows::FillBounds(const tile::Loops& loops, int block) {
  bounds_.assign(static_cast<std::size_t>(2 * all_tiles()), tile::Bounds{});
  SetMargins(kHeads, count_, 0.0F, 0.0F);
  SetMargins(kTails, count_, 0.0F, 0.0F);
  // The sums are rounded to 6e-8 of themselves. A product of a mean and a sum is at most the sum of all squares times
  // the root of the number of windows that fit side by side (Cauchy and Schwarz).
  const float squares = Column(kSquares)[count_ + length_ - 1];
  tile::BoundArguments arguments{};
  arguments.sums = Column(kSums);
  arguments.squares = Column(kSquares);
  arguments.mean = mean();
  arguments.scale = scale();
  arguments.rounding = 2e-6F * squares * std::sqrt(1.0F + static_cast<float>(count_) / static_cast<float>(length_));
  arguments.length = length_;
  arguments.block = block;
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
