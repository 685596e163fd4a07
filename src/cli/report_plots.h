#pragma once

#include <string>
#include <vector>

#include "cli/report_page.h"

/// \file
/// The plots of a report, and the choice of shapelets to show.

namespace contact_shapelets::cli {

/// Returns the colour of a cluster in a report, from Okabe and Ito's palette for colour-blind readers.
std::string ClusterColour(int cluster);

/// Returns the indices of the episodes that are nearest to `cluster`.
std::vector<std::size_t> MembersOf(const ReportContents& contents, int cluster);

/// Returns the indices of the shapelets that tell a cluster from the others, best first, at most `count`. Leaves out a
/// shapelet if its match in the episode `example` overlaps the match of a better one by more than half.
///
/// The separation of two clusters by a shapelet is the difference of its mean distances over the sum of their standard
/// deviations. The least separation from the other clusters counts. Returns none if no shapelet is nearer to the
/// cluster than to all others, or if no other cluster has episodes.
std::vector<Eigen::Index> FindTellingShapelets(const ReportContents& contents, int cluster, std::size_t example,
                                               std::size_t count);

/// Returns the member with the features nearest to the cluster's centroid. `members` are not empty.
std::size_t TypicalMember(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members);

/// Plots the median force of each cluster over time. Shifts the episodes to fit the most typical one.
std::string OverviewPlot(const ReportContents& contents);
/// Plots the same for one cluster with members, and a band that holds 80 % of them.
std::string TypicalPlot(const ReportContents& contents, int cluster);
/// Plots the force of an episode, with shapelets at the place of their matches.
std::string MatchPlot(const ReportContents& contents, std::size_t episode, const std::vector<Eigen::Index>& shapelets);
/// Plots the novelty of all episodes in the order of the bags, with the limit.
std::string NoveltyPlot(const ReportContents& contents);
/// Plots the force of one episode and of the most typical episode of the nearest cluster.
std::string NovelPlot(const ReportContents& contents, std::size_t episode);

}  // namespace contact_shapelets::cli
