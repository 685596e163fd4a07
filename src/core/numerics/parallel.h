#pragma once

#include <functional>

/// \file
/// Spreads independent work over threads.

namespace contact_shapelets::core {

/// As many threads as the machine runs at the same time but for `spare` ones, at least 1, where `requested` is 0; else
/// `requested`.
int ThreadCount(int requested, int spare = 0);

/// Calls `work(index)` for every index in 0 ... count - 1, spread over `threads` threads. Calls must not depend on each
/// other, so that the result is the same for any number of threads. The first exception thrown is thrown again here.
void ParallelFor(int count, int threads, const std::function<void(int)>& work);

}  // namespace contact_shapelets::core
