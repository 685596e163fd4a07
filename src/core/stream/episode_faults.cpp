#include "core/stream/episode_faults.h"

#include <algorithm>
#include <cstddef>

namespace contact_shapelets::core {
namespace {

constexpr Nanoseconds kFrozen = 250'000'000;
constexpr Nanoseconds kZeros = 100'000'000;
/// Fewer equal samples of a slow sensor may be chance.
constexpr int kHeld = 4;
/// Arrivals place this few samples well enough.
constexpr std::ptrdiff_t kWrongStamps = 2;

bool HasGap(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end, Nanoseconds longest) {
  Nanoseconds last = begin;
  for (const WrenchSample& sample : samples) {
    if (sample.time - last > longest) return true;
    last = sample.time;
  }
  return end - last > longest;
}

/// True if the run [first, end) holds a value that the sensor also gives elsewhere in the episode, as a coarse one or
/// one with a dead band does. Zeros count as such only at the episode's begin or end, which are in free air.
bool Recurs(const std::vector<WrenchSample>& samples, std::size_t first, std::size_t end) {
  const Eigen::Vector3d& force = samples[first].force;
  if (first > 0 && samples.front().force == force) return true;
  if (end < samples.size() && samples.back().force == force) return true;
  if (force.isZero(0.0)) return false;
  // A single equal sample is chance; two in a row are the sensor's steps.
  const auto equal_pair = [&force](const WrenchSample& one, const WrenchSample& next) {
    return one.force == force && next.force == force;
  };
  const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(first);
  const auto behind = samples.begin() + static_cast<std::ptrdiff_t>(end);
  return std::adjacent_find(samples.begin(), begin, equal_pair) != begin ||
         std::adjacent_find(behind, samples.end(), equal_pair) != samples.end();
}

/// A value lasts until the next sample.
std::uint32_t HeldFaults(const std::vector<WrenchSample>& samples, Nanoseconds end) {
  std::uint32_t faults = 0;
  std::size_t first = 0;
  for (std::size_t index = 1; index <= samples.size(); ++index) {
    const bool ends = index == samples.size();
    if (!ends && samples[index].force == samples[first].force) continue;
    const Nanoseconds held = (ends ? end : samples[index].time) - samples[first].time;
    if (index - first >= kHeld && !Recurs(samples, first, index)) {
      if (held >= kFrozen) faults |= BitOf(EpisodeFault::kFrozen);
      if (held >= kZeros && samples[first].force.isZero(0.0)) faults |= BitOf(EpisodeFault::kZeros);
    }
    first = index;
  }
  return faults;
}

}  // namespace

std::uint32_t FaultsOf(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end,
                       Nanoseconds longest_gap) {
  std::uint32_t faults = HeldFaults(samples, end);
  if (HasGap(samples, begin, end, longest_gap)) faults |= BitOf(EpisodeFault::kGap);
  const auto wrong =
      std::count_if(samples.begin(), samples.end(), [](const auto& sample) { return sample.wrong_stamp; });
  // If all stamps are wrong, all samples are on the clock of arrivals, and the episode is sound.
  const auto right = static_cast<std::ptrdiff_t>(samples.size()) - wrong;
  // Likewise if right ones are the exception, as with stamps in whole seconds.
  if (wrong > kWrongStamps && right > kWrongStamps && wrong < 10 * right) faults |= BitOf(EpisodeFault::kWrongStamps);
  return faults;
}

}  // namespace contact_shapelets::core
