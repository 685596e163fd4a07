#pragma once

#include <functional>

/// \file
/// Spreads independent work over threads.

namespace contact_shapelets::core {

/// Returns `requested`; if it is 0, the number of threads that the machine runs at the same time less `spare`, at
/// least 1.
int ThreadCount(int requested, int spare = 0);

/// Calls `work(index)` for every index in 0 ... count - 1, spread over `threads` threads. Calls must not depend on each
/// other; then the result is the same for any number of threads. If a call throws, no further calls begin, and this
/// function throws the first exception again.
void ParallelFor(int count, int threads, const std::function<void(int)>& work);

}  // namespace contact_shapelets::core
