#pragma once

#include <string>
#include <vector>

#include "cli/report_page.h"

/// \file
/// The plots of a report, and the shapelets that are worth showing.

namespace contact_shapelets::cli {

/// The colour that stands for a cluster throughout a report (Okabe and Ito's palette, told apart by
/// colour-blind eyes).
std::string ClusterColour(int cluster);

/// Indices of the episodes whose nearest cluster is `cluster`.
std::vector<std::size_t> MembersOf(const ReportContents& contents, int cluster);

/// The shapelets that tell a cluster from each of the others, by index, best first: at most `count`, none
/// whose match in the episode `example` overlaps a better one's by more than half.
///
/// A shapelet separates two clusters by the difference of its mean distances over the sum of the standard
/// deviations; what counts is the least of a cluster's separations from the others. None where no shapelet
/// lies nearer to the cluster than to all others, or no other cluster has episodes.
std::vector<Eigen::Index> FindTellingShapelets(const ReportContents& contents, int cluster, std::size_t example,
                                               std::size_t count);

/// The member whose features lie nearest to the cluster's centroid. `members` holds at least one.
std::size_t TypicalMember(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members);

/// The median force of each cluster over time, its episodes shifted to lie over the most typical one.
std::string OverviewPlot(const ReportContents& contents);
/// The same of one cluster, which has members, within the band that holds 80 % of them.
std::string TypicalPlot(const ReportContents& contents, int cluster);
/// The force of an episode, with shapelets drawn where they matched.
std::string MatchPlot(const ReportContents& contents, std::size_t episode, const std::vector<Eigen::Index>& shapelets);
/// The novelty of all episodes in the order of their recording, with the limit.
std::string NoveltyPlot(const ReportContents& contents);
/// The force of one episode, and that of the nearest cluster that is most typical.
std::string NovelPlot(const ReportContents& contents, std::size_t episode);

}  // namespace contact_shapelets::cli
