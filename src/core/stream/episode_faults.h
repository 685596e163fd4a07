#pragma once

#include <cstdint>
#include <vector>

#include "contact_shapelets/core/stream_summary.h"
#include "core/stream/wrench_sample.h"

/// \file
/// What is wrong with the samples of an episode.

namespace contact_shapelets::core {

/// Returns the bit of a fault in a set of faults.
constexpr std::uint32_t BitOf(EpisodeFault fault) { return 1U << static_cast<unsigned>(fault); }

/// Returns the faults of an episode's samples, one bit each: a gap of more than `longest_gap`; one value for 0.25 s;
/// exact zeros for 0.1 s; more than two wrong stamps besides more than two right ones. `samples` are not empty and lie
/// in [begin, end].
std::uint32_t FaultsOf(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end,
                       Nanoseconds longest_gap);

}  // namespace contact_shapelets::core
