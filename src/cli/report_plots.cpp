#include "cli/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/svg_plot.h"
#include "cli/text.h"
#include "core/matching/ncc_kernel.h"
#include "core/numerics/series.h"

namespace contact_shapelets::cli {
namespace {

constexpr int kWidth = 760;
constexpr int kHeight = 260;
constexpr std::size_t kAlignedMembers = 100;
constexpr char kForceColour[] = "#555555";
constexpr std::array<const char*, 3> kShapeletColours{"#d55e00", "#0072b2", "#009e73"};

const core::Diagnosis& DiagnosisOf(const ReportContents& contents, std::size_t episode) {
  return contents.results[episode].diagnosis;
}

/// Returns the `quantile` of `values`.
double Quantile(std::vector<double> values, double quantile) {
  std::sort(values.begin(), values.end());
  const double place = quantile * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

/// Returns the shift in samples with the greatest covariance of `series` and `reference` where they overlap.
Eigen::Index BestShift(const Eigen::VectorXf& series, const Eigen::VectorXf& reference) {
  const Eigen::VectorXf centred = series.array() - series.mean();
  const Eigen::VectorXf target = reference.array() - reference.mean();
  Eigen::Index best_shift = 0;
  float best = -1.0F;
  const Eigen::Index most = reference.size() / 2;
  for (Eigen::Index shift = -most; shift <= most; ++shift) {
    const Eigen::Index begin = std::max<Eigen::Index>(0, shift);
    const Eigen::Index length = std::min(target.size(), centred.size() + shift) - begin;
    if (length <= 0) continue;
    const float covariance = target.segment(begin, length).dot(centred.segment(begin - shift, length));
    if (covariance > best) {
      best = covariance;
      best_shift = shift;
    }
  }
  return best_shift;
}

/// The members of a cluster, shifted to fit the most typical one. Of a large cluster, only enough for a median.
struct AlignedMembers {
  std::vector<std::size_t> episodes;
  std::vector<Eigen::Index> shifts;
  Eigen::Index length = 0;  ///< length of the most typical member
};

AlignedMembers Align(const ReportContents& contents, int cluster) {
  const std::vector<std::size_t> members = MembersOf(contents, cluster);
  AlignedMembers aligned;
  if (members.empty()) return aligned;
  const Eigen::VectorXf& reference = contents.series[TypicalMember(contents, cluster, members)];
  aligned.length = reference.size();
  const std::size_t step = 1 + (members.size() - 1) / kAlignedMembers;
  for (std::size_t index = 0; index < members.size(); index += step) {
    aligned.episodes.push_back(members[index]);
    aligned.shifts.push_back(BestShift(contents.series[members[index]], reference));
  }
  return aligned;
}

/// Returns the quantile of the members' forces at each time at which at least half of them have a force.
std::vector<PlotPoint> QuantileCurve(const ReportContents& contents, const AlignedMembers& members, double quantile) {
  std::vector<PlotPoint> curve;
  for (Eigen::Index sample = 0; sample < members.length; ++sample) {
    std::vector<double> values;
    for (std::size_t index = 0; index < members.episodes.size(); ++index) {
      const Eigen::VectorXf& series = contents.series[members.episodes[index]];
      const Eigen::Index place = sample - members.shifts[index];
      if (place >= 0 && place < series.size()) values.push_back(series[place]);
    }
    if (2 * values.size() < members.episodes.size()) continue;
    curve.push_back({static_cast<double>(sample) * contents.model.sample_period, Quantile(values, quantile)});
  }
  return curve;
}

std::vector<PlotPoint> ForceCurve(const ReportContents& contents, std::size_t episode) {
  std::vector<PlotPoint> curve;
  const Eigen::VectorXf& series = contents.series[episode];
  for (Eigen::Index sample = 0; sample < series.size(); ++sample) {
    curve.push_back({static_cast<double>(sample) * contents.model.sample_period, series[sample]});
  }
  return curve;
}

/// Returns axes that hold all `curves`, with time and force from 0.
SvgPlot ForceAxes(const std::vector<std::vector<PlotPoint>>& curves) {
  PlotAxis time{"time from the episode's start [s]", 0.0, 0.0};
  PlotAxis force{"force [N]", 0.0, 0.0};
  for (const std::vector<PlotPoint>& curve : curves) {
    for (const PlotPoint& point : curve) {
      time.greatest = std::max(time.greatest, point.x);
      force.greatest = std::max(force.greatest, 1.05 * point.y);
      force.least = std::min(force.least, 1.05 * point.y);
    }
  }
  return SvgPlot(time, force, kWidth, kHeight);
}

/// Returns a shapelet at its best match in the episode: scaled to the window and moved by the best shift.
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

/// Mean and standard deviation of the distances [members, K] of a cluster's episodes to each shapelet.
struct DistanceSpread {
  Eigen::ArrayXf mean;
  Eigen::ArrayXf deviation;
};

DistanceSpread SpreadOf(const ReportContents& contents, const std::vector<std::size_t>& members) {
  const auto shapelets = static_cast<Eigen::Index>(contents.model.shapelets.size());
  Eigen::ArrayXXf distances(shapelets, members.size());
  for (std::size_t index = 0; index < members.size(); ++index) {
    distances.col(static_cast<Eigen::Index>(index)) = contents.results[members[index]].features.distances;
  }
  DistanceSpread spread;
  spread.mean = distances.rowwise().mean();
  spread.deviation = (distances.colwise() - spread.mean).square().rowwise().mean().sqrt();
  return spread;
}

/// Returns the least separation of a cluster from the others by each shapelet; an empty array if there is no other
/// cluster with episodes.
Eigen::ArrayXf Separations(const ReportContents& contents, int cluster) {
  const DistanceSpread own = SpreadOf(contents, MembersOf(contents, cluster));
  Eigen::ArrayXf least;
  for (int other = 0; other < static_cast<int>(contents.model.clusters.size()); ++other) {
    const std::vector<std::size_t> members = MembersOf(contents, other);
    if (other == cluster || members.empty()) continue;
    const DistanceSpread spread = SpreadOf(contents, members);
    const Eigen::ArrayXf separation = (spread.mean - own.mean) / (spread.deviation + own.deviation + 1e-3F);
    least = least.size() == 0 ? separation : least.min(separation).eval();
  }
  return least;
}

/// Returns true if two matches overlap by more than half of the shorter.
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

std::vector<Eigen::Index> FindTellingShapelets(const ReportContents& contents, int cluster, std::size_t example,
                                               std::size_t count) {
  const Eigen::ArrayXf separations = Separations(contents, cluster);
  const core::ShapeletDistances& features = contents.results[example].features;
  std::vector<Eigen::Index> candidates;
  for (Eigen::Index index = 0; index < separations.size(); ++index) {
    if (separations[index] > 0.0F && features.match_start[index] >= 0) candidates.push_back(index);
  }
  std::sort(candidates.begin(), candidates.end(), [&separations](Eigen::Index first, Eigen::Index second) {
    return separations[first] > separations[second];
  });
  std::vector<Eigen::Index> chosen;
  for (const Eigen::Index candidate : candidates) {
    const auto hides = [&](Eigen::Index better) { return Overlap(features, better, candidate); };
    if (chosen.size() < count && std::none_of(chosen.begin(), chosen.end(), hides)) chosen.push_back(candidate);
  }
  return chosen;
}

std::size_t TypicalMember(const ReportContents& contents, int cluster, const std::vector<std::size_t>& members) {
  const auto distance = [&](std::size_t member) {
    const Eigen::VectorXf features =
        contents.model.Features(contents.results[member].features.distances.transpose()).transpose();
    return (features - contents.model.clusters[static_cast<std::size_t>(cluster)].centroid).norm();
  };
  return *std::min_element(members.begin(), members.end(),
                           [&](std::size_t first, std::size_t second) { return distance(first) < distance(second); });
}

std::string OverviewPlot(const ReportContents& contents) {
  std::vector<std::vector<PlotPoint>> curves;
  for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
    curves.push_back(QuantileCurve(contents, Align(contents, cluster), 0.5));
  }
  SvgPlot plot = ForceAxes(curves);
  for (int cluster = 0; cluster < static_cast<int>(curves.size()); ++cluster) {
    const std::vector<PlotPoint>& curve = curves[static_cast<std::size_t>(cluster)];
    if (!curve.empty()) plot.AddLine(curve, ClusterColour(cluster), 2.0, contents.model.EventOf(cluster));
  }
  return plot.Text();
}

std::string TypicalPlot(const ReportContents& contents, int cluster) {
  const AlignedMembers members = Align(contents, cluster);
  const std::vector<PlotPoint> lower = QuantileCurve(contents, members, 0.1);
  const std::vector<PlotPoint> upper = QuantileCurve(contents, members, 0.9);
  SvgPlot plot = ForceAxes({upper, lower});
  plot.AddBand(upper, lower, ClusterColour(cluster));
  plot.AddLine(QuantileCurve(contents, members, 0.5), ClusterColour(cluster), 2.0,
               "median of " + Count(members.episodes.size(), "episode") + ", band from 10 % to 90 %");
  return plot.Text();
}

std::string MatchPlot(const ReportContents& contents, std::size_t episode, const std::vector<Eigen::Index>& shapelets) {
  std::vector<std::vector<PlotPoint>> curves{ForceCurve(contents, episode)};
  for (const Eigen::Index shapelet : shapelets) curves.push_back(MatchCurve(contents, episode, shapelet));
  SvgPlot plot = ForceAxes(curves);
  plot.AddLine(curves.front(), kForceColour, 1.2, "episode " + contents.episodes[episode].id);
  for (std::size_t index = 0; index < shapelets.size(); ++index) {
    const float distance = contents.results[episode].features.distances[shapelets[index]];
    plot.AddLine(curves[index + 1], kShapeletColours[index % kShapeletColours.size()], 3.0,
                 "shapelet " + std::to_string(shapelets[index]) + " (" + Number(distance, 3) + ")");
  }
  return plot.Text();
}

std::string NoveltyPlot(const ReportContents& contents) {
  double greatest = 1.0;
  for (const core::Classification& result : contents.results) {
    greatest = std::max(greatest, static_cast<double>(result.diagnosis.novelty));
  }
  const auto last = static_cast<double>(contents.results.size());
  SvgPlot plot({"episode, in the order of the bags", 0.0, last + 1.0}, {"novelty", 0.0, 1.1 * greatest}, kWidth,
               kHeight);
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
  std::vector<std::size_t> known = MembersOf(contents, cluster);
  const auto is_novel = [&contents](std::size_t member) { return DiagnosisOf(contents, member).cluster < 0; };
  known.erase(std::remove_if(known.begin(), known.end(), is_novel), known.end());
  const std::vector<PlotPoint> force = ForceCurve(contents, episode);
  std::vector<PlotPoint> typical;
  std::string typical_label;
  if (!known.empty()) {
    const std::size_t member = TypicalMember(contents, cluster, known);
    typical = ForceCurve(contents, member);
    typical_label = "most typical of " + contents.model.EventOf(cluster) + ": " + contents.episodes[member].id;
  }
  SvgPlot plot = ForceAxes({force, typical});
  if (!typical.empty()) plot.AddLine(typical, ClusterColour(cluster), 1.4, typical_label);
  plot.AddLine(force, kForceColour, 1.4, "episode " + contents.episodes[episode].id);
  return plot.Text();
}

}  // namespace contact_shapelets::cli
