#pragma once

#include <cstdint>
#include <vector>

#include "contact_shapelets/core/stream_summary.h"
#include "core/stream/wrench_sample.h"

/// \file
/// What is wrong with the samples of an episode.

namespace contact_shapelets::core {

/// The bit of a fault in a set of them.
constexpr std::uint32_t BitOf(EpisodeFault fault) { return 1U << static_cast<unsigned>(fault); }

/// The faults of an episode's samples, a bit for each: a gap of more than `longest_gap`, a sensor that holds one value
/// for 0.25 s or exact zeros for 0.1 s, more than two samples with a wrong stamp among others with a right one.
/// `samples` are not empty and lie in [begin, end].
std::uint32_t FaultsOf(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end,
                       Nanoseconds longest_gap);

}  // namespace contact_shapelets::core
