#pragma once

#include <cstdint>
#include <vector>

/// \file
/// How well found change points agree with true ones.

namespace contact_shapelets::evaluation {

/// The covering in [0, 1] of the true segments by the found ones: the mean over the true segments, weighted by their
/// lengths, of the largest intersection over union with any found segment (Arbelaez et al. 2011; as the authors of
/// ClaSP use it). 1 if both agree.
///
/// Change points are the indices at which a segment begins, in any order, in (0, length); `length` is that of the
/// series in samples, at least 1. \throws std::invalid_argument if they are not.
double Covering(const std::vector<std::int64_t>& true_change_points,
                const std::vector<std::int64_t>& found_change_points, std::int64_t length);

}  // namespace contact_shapelets::evaluation
