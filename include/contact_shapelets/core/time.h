#pragma once

#include <cmath>
#include <cstdint>

/// \file
/// Points in time and durations.

namespace contact_shapelets::core {

/// A point in time or a duration in nanoseconds; exact, unlike a double at today's date.
using Nanoseconds = std::int64_t;

/// The duration of `seconds`, rounded to the nearest nanosecond; at most 9e9 s either way.
inline Nanoseconds FromSeconds(double seconds) { return static_cast<Nanoseconds>(std::llround(seconds * 1e9)); }

/// `duration` in seconds.
inline double ToSeconds(Nanoseconds duration) { return 1e-9 * static_cast<double>(duration); }

}  // namespace contact_shapelets::core
