#pragma once

#include <functional>

/// \file
/// Spreads independent work over threads.

namespace contact_shapelets::core {

/// Returns `requested`, or the number of threads that the machine runs at the same time if `requested` is 0.
int ThreadCount(int requested);

/// Calls `work(index)` for every index in 0 ... count - 1, spread over `threads` threads. Calls must not depend on each
/// other; then the result is the same for any number of threads. If a call throws, no further calls begin, and this
/// function throws the first exception again.
void ParallelFor(int count, int threads, const std::function<void(int)>& work);

}  // namespace contact_shapelets::core
