#include "core/ncc_prepared.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {
namespace {

using tile::kGroup;
using tile::kPadding;

/// By Cauchy and Schwarz the rounding of a sum in single precision is at most some 6e-8 of the norm of the values near a
/// window; where that is too much for the window's deviation, the window is summed up in double precision.
constexpr double kHardRatio = 150.0;
/// M sigma of a window that does not count: no sum exceeds it.
constexpr float kNever = 1e30F;
/// A bound that prunes nothing.
constexpr float kUnbounded = 8.0F;

/// Few blocks cost bounds that are loose, many cost the time to look at them.
int BlockSize(int length) { return std::clamp(length / 12, 2, 8); }

OverlapSide SideOf(const PreparedShapelets& prepared, const Eigen::Ref<const Eigen::MatrixXf>& normalised, bool reverse) {
  const int length = prepared.length;
  OverlapSide side;
  side.values = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
  side.within = Eigen::MatrixXf::Zero(kGroup, length * prepared.groups);
  side.energy = Eigen::MatrixXf::Zero(kGroup, prepared.blocks * prepared.groups);
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
      if (m + 1 < length) side.energy(row, prepared.blocks * group + m / prepared.block) = static_cast<float>(energy / length);
    }
  }
  return side;
}

}  // namespace

PreparedShapelets::PreparedShapelets(const Eigen::Ref<const Eigen::MatrixXf>& normalised)
    : length(static_cast<int>(normalised.rows())),
      groups((static_cast<int>(normalised.cols()) + kGroup - 1) / kGroup),
      block(BlockSize(length)),
      blocks((length - 1 + block - 1) / block) {
  for (Eigen::Index k = 0; k < normalised.cols(); ++k) constant.push_back(normalised.col(k).isZero(0.0F));
  prefix = SideOf(*this, normalised, false);
  suffix = SideOf(*this, normalised, true);
}

PreparedWindows::PreparedWindows(const tile::Loops& loops, const WindowSet& windows, int first, int count, int block,
                                 int blocks, bool prune)
    : length_(windows.length()),
      first_(first),
      count_(count),
      tile_(loops.positions),
      further_tiles_((length_ - 1 + tile_ - 1) / tile_),
      margin_(length_ + 2 * kPadding),
      block_(block),
      blocks_(blocks) {
  FillWindows(windows);
  FillBounds(loops, windows, prune);
}

void PreparedWindows::FillWindows(const WindowSet& windows) {
  const int samples = count_ + length_ - 1;
  const int size = samples + 2 * margin_;
  const Eigen::ArrayXd part = windows.series().segment(first_, samples).cast<double>();
  const double centre = part.mean();
  series_.setZero(size);
  series_.segment(margin_, samples) = (part - centre).cast<float>();
  sums_.setZero(samples + 1 + 2 * kPadding);
  squares_.setZero(samples + 1 + 2 * kPadding);
  for (Eigen::Index q = 0; q < samples; ++q) {
    const double value = part[q] - centre;
    sums_[q + 1] = sums_[q] + value;
    squares_[q + 1] = squares_[q] + value * value;
  }

  mean_.setZero(size);
  spread_.setConstant(size, kNever);
  scale_.setZero(size);
  for (int j = 0; j < count_; ++j) {
    const double inverse = windows.inverse_deviation()[first_ + j];
    if (inverse == 0.0) continue;
    // All values that a sum at a position near this window can hold.
    const int begin = std::max(0, j - length_);
    const int end = std::min(samples, j + 2 * length_);
    if (inverse * inverse * (squares_[end] - squares_[begin]) > kHardRatio * kHardRatio) {
      hard_.push_back(first_ + j);
      continue;
    }
    mean_[margin_ + j] = static_cast<float>(windows.mean()[first_ + j] - centre);
    spread_[margin_ + j] = static_cast<float>(length_ / inverse);
    scale_[margin_ + j] = static_cast<float>(inverse / length_);
  }
}

void PreparedWindows::FillBounds(const tile::Loops& loops, const WindowSet& windows, bool prune) {
  const int tiles = full_tiles() + 2 * further_tiles_;
  prefix_bounds_.setZero(tiles * blocks_);
  suffix_bounds_.setZero(tiles * blocks_);
  const Eigen::ArrayXd mean = mean_.segment(margin_, count_ + kPadding).cast<double>();
  Eigen::ArrayXd scale = Eigen::ArrayXd::Zero(count_ + kPadding);
  scale.head(count_) = windows.inverse_deviation().segment(first_, count_).array().square() / length_;
  scale = (scale_.segment(margin_, count_ + kPadding) > 0.0F).select(scale, 0.0);

  tile::EnergyArguments arguments{sums_.data(), squares_.data(), mean.data(), scale.data(), 0, 0, count_};
  Eigen::ArrayXf prefix = Eigen::ArrayXf::Constant(count_ + kPadding, kUnbounded);
  Eigen::ArrayXf suffix = prefix;
  for (int block = 0; block < blocks_; ++block) {
    if (prune) {
      arguments.overlap = std::min((block + 1) * block_, length_ - 1);
      arguments.first = length_ - arguments.overlap;
      loops.window_energies(arguments, prefix.data());
      arguments.first = 0;
      loops.window_energies(arguments, suffix.data());
    }
    FillBlock(block, prefix, suffix);
  }
}

void PreparedWindows::FillBlock(int block, const Eigen::Ref<const Eigen::ArrayXf>& prefix,
                                const Eigen::Ref<const Eigen::ArrayXf>& suffix) {
  const int least = block * block_ + 1;
  const int most = std::min((block + 1) * block_, length_ - 1);
  const auto largest = [this](const Eigen::Ref<const Eigen::ArrayXf>& energies, int begin, int end) {
    begin = std::max(begin, 0);
    end = std::min(end, count_);
    return begin < end ? energies.segment(begin, end - begin).maxCoeff() : 0.0F;
  };
  for (int tile = -further_tiles_; tile < full_tiles() + further_tiles_; ++tile) {
    const int begin = tile * tile_;
    const int entry = (tile + further_tiles_) * blocks_ + block;
    prefix_bounds_[entry] = largest(prefix, begin + least - length_, begin + tile_ + most - length_);
    suffix_bounds_[entry] = largest(suffix, begin + length_ - most, begin + tile_ + length_ - least);
  }
}

}  // namespace contact_shapelets::core
