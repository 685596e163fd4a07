#pragma once

#include <cstddef>
#include <vector>

#include "core/stream/wrench_sample.h"

namespace contact_shapelets::core {

/// A ring buffer of the last samples, oldest first.
class SampleBuffer {
 public:
  /// Keeps `capacity` samples.
  explicit SampleBuffer(std::size_t capacity) : samples_(capacity) {}
  /// Adds the newest sample. A full buffer forgets the oldest.
  void Add(const WrenchSample& sample) {
    if (size_ < samples_.size()) {
      samples_[(first_ + size_) % samples_.size()] = sample;
      ++size_;
    } else {
      samples_[first_] = sample;
      first_ = (first_ + 1) % samples_.size();
    }
  }
  /// Forgets all samples.
  void Clear() { size_ = 0; }
  /// Returns true if there is no sample.
  bool empty() const { return size_ == 0; }
  /// Returns the newest sample.
  const WrenchSample& back() const { return (*this)[size_ - 1]; }
  /// Returns the samples with begin <= time <= end.
  std::vector<WrenchSample> Between(Nanoseconds begin, Nanoseconds end) const {
    std::size_t low = size_;
    while (low > 0 && (*this)[low - 1].time >= begin) --low;
    std::vector<WrenchSample> between;
    for (; low < size_ && (*this)[low].time <= end; ++low) between.push_back((*this)[low]);
    return between;
  }

 private:
  const WrenchSample& operator[](std::size_t index) const { return samples_[(first_ + index) % samples_.size()]; }

  std::vector<WrenchSample> samples_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace contact_shapelets::core
