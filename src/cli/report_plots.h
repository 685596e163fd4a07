#pragma once

#include <string>
#include <vector>

#include "cli/report_page.h"

/// \file
/// The plots of a report, and the shapelets that are worth showing.

namespace contact_shapelets::cli {

/// The colour that stands for a cluster throughout a report (Okabe and Ito's palette, told apart by colour-blind eyes).
std::string ClusterColour(int cluster);

/// Indices of the episodes whose nearest cluster is `cluster`.
std::vector<std::size_t> MembersOf(const ReportContents& contents, int cluster);

/// A shapelet that tells a cluster from the rest.
struct TellingShapelet {
  Eigen::Index index = 0;
  double inside = 0.0;      ///< mean distance of the cluster's episodes
  double outside = 0.0;     ///< mean distance of all others
  double separation = 0.0;  ///< (outside - inside) over the sum of both standard deviations
};

/// The shapelets that lie nearer to the cluster's episodes than to all others, best first: at most `count`, none whose
/// match in `example` overlaps a better one's by more than half. None where the cluster has no episode or has all.
std::vector<TellingShapelet> FindTellingShapelets(const ReportContents& contents, int cluster, std::size_t example,
                                                  std::size_t count);

/// The member whose features lie nearest to the cluster's centroid. `members` holds at least one.
std::size_t TypicalMember(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members);

/// The median force of each cluster over time.
std::string OverviewPlot(const ReportContents& contents);
/// The median force of `members` over time, within the band that holds 80 % of them.
std::string TypicalPlot(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members);
/// The force of an episode, with shapelets drawn where they matched.
std::string MatchPlot(const ReportContents& contents, std::size_t episode, const std::vector<TellingShapelet>& shapelets);
/// The novelty of all episodes in the order of their recording, with the limit.
std::string NoveltyPlot(const ReportContents& contents);
/// The force of one episode over the median of the nearest cluster.
std::string NovelPlot(const ReportContents& contents, std::size_t episode);

}  // namespace contact_shapelets::cli
