#pragma once

#include <cstdint>
#include <vector>

#include "core/matching/ncc_windows.h"

/// \file
/// Normalised cross-correlation between shapelets and an episode (equations 2 and 3 of the paper).
///
/// For a shapelet s of M samples and a series t of Q samples there are J = Q - M + 1 windows t_j. Both s and t_j are
/// z-normalised over their own M samples (population standard deviation). CC_w is the zero-padded cross-correlation at
/// shift w in [-(M-1), M-1], divided by M:
///
///     CC_w(s, t_j) = 1/M sum_m s^z[m] t_j^z[m + w]   over all m with 0 <= m < M and 0 <= m + w < M.
///
/// The best match is the largest CC_w over all windows j and shifts w.

namespace contact_shapelets::core {

/// The best match of one shapelet within one series. There is none if the shapelet is constant or all windows are flat.
struct Match {
  float similarity = -1.0F;  ///< max_j max_w CC_w, in [-1, 1]; -1 if there is no match
  std::int32_t window = -1;  ///< j of that maximum, 0 <= j < J; -1 if there is no match
  std::int32_t shift = 0;    ///< w of that maximum, -(M-1) <= w <= M-1
};

/// Returns the K best matches by the definition, sum by sum in double precision: O(J M^2) per shapelet. Tests compare
/// the kernel with it. \throws std::invalid_argument if the lengths differ.
std::vector<Match> BestMatchesByDefinition(const WindowSet& windows, const ShapeletSet& shapelets);

}  // namespace contact_shapelets::core
