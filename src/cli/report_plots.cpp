#include "cli/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/svg_plot.h"
#include "cli/text.h"
#include "contact_shapelets/core/ncc.h"
#include "contact_shapelets/core/series.h"

namespace contact_shapelets::cli {
namespace {

constexpr int kWidth = 760;
constexpr int kHeight = 260;
constexpr char kForceColour[] = "#555555";
constexpr std::array<const char*, 3> kShapeletColours{"#d55e00", "#0072b2", "#009e73"};

const core::Diagnosis& DiagnosisOf(const ReportContents& contents, std::size_t episode) {
  return contents.results[episode].diagnosis;
}

/// The value below which the part `quantile` of `values` lies.
double Quantile(std::vector<double> values, double quantile) {
  std::sort(values.begin(), values.end());
  const double place = quantile * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

/// The quantile of the members' forces at each time, as long as half of the members last.
std::vector<PlotPoint> QuantileCurve(const ReportContents& contents, const std::vector<std::size_t>& members,
                                     double quantile) {
  std::vector<PlotPoint> curve;
  for (Eigen::Index sample = 0;; ++sample) {
    std::vector<double> values;
    for (const std::size_t member : members) {
      if (sample < contents.series[member].size()) values.push_back(contents.series[member][sample]);
    }
    if (values.empty() || 2 * values.size() < members.size()) return curve;
    curve.push_back({static_cast<double>(sample) * contents.model.sample_period, Quantile(values, quantile)});
  }
}

std::vector<PlotPoint> ForceCurve(const ReportContents& contents, std::size_t episode) {
  std::vector<PlotPoint> curve;
  const Eigen::VectorXf& series = contents.series[episode];
  for (Eigen::Index sample = 0; sample < series.size(); ++sample) {
    curve.push_back({static_cast<double>(sample) * contents.model.sample_period, series[sample]});
  }
  return curve;
}

/// Axes that hold all `curves`: time from 0, force from 0.
SvgPlot ForceAxes(const std::vector<std::vector<PlotPoint>>& curves) {
  PlotAxis time{"time from the episode's start [s]", 0.0, 0.0};
  PlotAxis force{"force [N]", 0.0, 0.0};
  for (const std::vector<PlotPoint>& curve : curves) {
    for (const PlotPoint& point : curve) {
      time.greatest = std::max(time.greatest, point.x);
      force.greatest = std::max(force.greatest, 1.05 * point.y);
      force.least = std::min(force.least, point.y);
    }
  }
  return SvgPlot(time, force, kWidth, kHeight);
}

/// A shapelet as it lay over the episode at its best match: scaled to the window, moved by the best shift.
std::vector<PlotPoint> MatchCurve(const ReportContents& contents, std::size_t episode, Eigen::Index index) {
  const core::Shapelet& shapelet = contents.model.shapelets[static_cast<std::size_t>(index)];
  const int start = contents.results[episode].features.match_start[index];
  const Eigen::Index length = shapelet.values.size();
  const int span = static_cast<int>((length - 1) * shapelet.dilation + 1);
  std::vector<PlotPoint> curve;
  if (start < 0) return curve;
  const Eigen::VectorXf series = core::ExtendedTo(contents.series[episode], start + span);
  const Eigen::VectorXf window = core::EveryNth(series.segment(start, span), 0, shapelet.dilation);
  std::vector<core::Match> matches;
  core::FindBestMatches(core::WindowSet(window, static_cast<int>(length), 0.0),
                        core::ShapeletSet(shapelet.values.transpose()), {}, {}, &matches);
  const double deviation = core::StandardDeviation(window);
  for (Eigen::Index sample = 0; sample < length; ++sample) {
    const Eigen::Index place = sample + matches.front().shift;
    if (place < 0 || place >= length) continue;
    const auto at = static_cast<double>(start + place * shapelet.dilation);
    curve.push_back({at * contents.model.sample_period, window.mean() + deviation * shapelet.values[sample]});
  }
  return curve;
}

/// Mean and standard deviation of the distances of some episodes to a shapelet.
std::pair<double, double> DistanceSpread(const ReportContents& contents, Eigen::Index shapelet, int cluster, bool inside) {
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (const core::Classification& result : contents.results) {
    if ((result.diagnosis.nearest_cluster == cluster) != inside) continue;
    const double distance = result.features.distances[shapelet];
    sum += distance;
    squares += distance * distance;
    ++count;
  }
  if (count == 0.0) return {0.0, 0.0};
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/// Whether one of two matches lies within the other by more than half of the shorter.
bool Overlap(const core::ShapeletDistances& features, Eigen::Index first, Eigen::Index second) {
  const int begin = std::max(features.match_start[first], features.match_start[second]);
  const int end = std::min(features.match_start[first] + features.match_span[first],
                           features.match_start[second] + features.match_span[second]);
  return 2 * (end - begin) > std::min(features.match_span[first], features.match_span[second]);
}

}  // namespace

std::string ClusterColour(int cluster) {
  constexpr std::array<const char*, 7> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#56b4e9", "#e69f00", "#000000"};
  return kColours[static_cast<std::size_t>(cluster) % kColours.size()];
}

std::vector<std::size_t> MembersOf(const ReportContents& contents, int cluster) {
  std::vector<std::size_t> members;
  for (std::size_t index = 0; index < contents.results.size(); ++index) {
    if (DiagnosisOf(contents, index).nearest_cluster == cluster) members.push_back(index);
  }
  return members;
}

std::vector<TellingShapelet> FindTellingShapelets(const ReportContents& contents, int cluster, std::size_t example,
                                                  std::size_t count) {
  const std::size_t members = MembersOf(contents, cluster).size();
  if (members == 0 || members == contents.results.size()) return {};
  std::vector<TellingShapelet> candidates;
  const core::ShapeletDistances& features = contents.results[example].features;
  for (Eigen::Index index = 0; index < features.distances.size(); ++index) {
    const auto [inside, inside_spread] = DistanceSpread(contents, index, cluster, true);
    const auto [outside, outside_spread] = DistanceSpread(contents, index, cluster, false);
    if (features.match_start[index] < 0 || outside <= inside) continue;
    candidates.push_back({index, inside, outside, (outside - inside) / (inside_spread + outside_spread + 1e-3)});
  }
  std::sort(candidates.begin(), candidates.end(), [](const TellingShapelet& first, const TellingShapelet& second) {
    return first.separation > second.separation;
  });
  std::vector<TellingShapelet> chosen;
  for (const TellingShapelet& candidate : candidates) {
    const bool hidden = std::any_of(chosen.begin(), chosen.end(), [&](const TellingShapelet& better) {
      return Overlap(features, better.index, candidate.index);
    });
    if (!hidden && chosen.size() < count) chosen.push_back(candidate);
  }
  return chosen;
}

std::size_t TypicalMember(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members) {
  const auto distance = [&](std::size_t member) {
    const Eigen::VectorXf features =
        contents.model.Features(contents.results[member].features.distances.transpose()).transpose();
    return (features - contents.model.clusters[static_cast<std::size_t>(cluster)].centroid).norm();
  };
  return *std::min_element(members.begin(), members.end(), [&](std::size_t first, std::size_t second) {
    return distance(first) < distance(second);
  });
}

std::string OverviewPlot(const ReportContents& contents) {
  std::vector<std::vector<PlotPoint>> curves;
  for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
    curves.push_back(QuantileCurve(contents, MembersOf(contents, cluster), 0.5));
  }
  SvgPlot plot = ForceAxes(curves);
  for (int cluster = 0; cluster < static_cast<int>(curves.size()); ++cluster) {
    const std::vector<PlotPoint>& curve = curves[static_cast<std::size_t>(cluster)];
    if (!curve.empty()) plot.AddLine(curve, ClusterColour(cluster), 2.0, contents.model.EventOf(cluster));
  }
  return plot.Text();
}

std::string TypicalPlot(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members) {
  const std::vector<PlotPoint> lower = QuantileCurve(contents, members, 0.1);
  const std::vector<PlotPoint> upper = QuantileCurve(contents, members, 0.9);
  SvgPlot plot = ForceAxes({upper, lower});
  plot.AddBand(upper, lower, ClusterColour(cluster));
  plot.AddLine(QuantileCurve(contents, members, 0.5), ClusterColour(cluster), 2.0,
               "median of " + Count(members.size(), "episode") + ", band from 10 % to 90 %");
  return plot.Text();
}

std::string MatchPlot(const ReportContents& contents, std::size_t episode, const std::vector<TellingShapelet>& shapelets) {
  std::vector<std::vector<PlotPoint>> curves{ForceCurve(contents, episode)};
  for (const TellingShapelet& shapelet : shapelets) curves.push_back(MatchCurve(contents, episode, shapelet.index));
  SvgPlot plot = ForceAxes(curves);
  plot.AddLine(curves.front(), kForceColour, 1.2, "episode " + contents.episodes[episode].id);
  for (std::size_t index = 0; index < shapelets.size(); ++index) {
    const std::string label = "shapelet " + std::to_string(shapelets[index].index) + ", distance " +
                              Number(contents.results[episode].features.distances[shapelets[index].index], 3);
    plot.AddLine(curves[index + 1], kShapeletColours[index % kShapeletColours.size()], 3.0, label);
  }
  return plot.Text();
}

std::string NoveltyPlot(const ReportContents& contents) {
  double greatest = 1.0;
  for (const core::Classification& result : contents.results) {
    greatest = std::max(greatest, static_cast<double>(result.diagnosis.novelty));
  }
  const auto last = static_cast<double>(contents.results.size());
  SvgPlot plot({"episode, in the order of the bags", 0.0, last + 1.0}, {"novelty", 0.0, 1.1 * greatest}, kWidth, kHeight);
  plot.AddLine({{0.0, 1.0}, {last + 1.0, 1.0}}, "#999999", 1.0, "limit");
  for (std::size_t index = 0; index < contents.results.size(); ++index) {
    const core::Diagnosis& diagnosis = DiagnosisOf(contents, index);
    plot.AddDot({static_cast<double>(index) + 1.0, diagnosis.novelty}, ClusterColour(diagnosis.nearest_cluster),
                contents.episodes[index].id + ": " + diagnosis.event + ", novelty " + Number(diagnosis.novelty, 2));
  }
  for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
    plot.AddLegend(ClusterColour(cluster), "nearest to " + contents.model.EventOf(cluster));
  }
  return plot.Text();
}

std::string NovelPlot(const ReportContents& contents, std::size_t episode) {
  const int cluster = DiagnosisOf(contents, episode).nearest_cluster;
  std::vector<std::size_t> known;
  for (const std::size_t member : MembersOf(contents, cluster)) {
    if (DiagnosisOf(contents, member).cluster == cluster) known.push_back(member);
  }
  const std::vector<PlotPoint> median = QuantileCurve(contents, known, 0.5);
  const std::vector<PlotPoint> force = ForceCurve(contents, episode);
  SvgPlot plot = ForceAxes({median, force});
  if (!median.empty()) {
    plot.AddLine(median, ClusterColour(cluster), 2.0, "median of " + contents.model.EventOf(cluster));
  }
  plot.AddLine(force, kForceColour, 1.4, "episode " + contents.episodes[episode].id);
  return plot.Text();
}

}  // namespace contact_shapelets::cli
