#pragma once

#include <cmath>
#include <cstdint>

/// \file
/// Points in time and durations.

namespace contact_shapelets::core {

/// A point in time or a duration in nanoseconds. A double could not hold today's date exactly.
using Nanoseconds = std::int64_t;

/// Returns `seconds`, which lies in [-9e9, 9e9], rounded to the nearest nanosecond.
inline Nanoseconds FromSeconds(double seconds) { return static_cast<Nanoseconds>(std::llround(seconds * 1e9)); }

/// Returns `duration` in seconds.
inline double ToSeconds(Nanoseconds duration) { return 1e-9 * static_cast<double>(duration); }

}  // namespace contact_shapelets::core
