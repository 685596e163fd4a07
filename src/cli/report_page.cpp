#include "cli/report_page.h"

#include <algorithm>

#include "cli/event_scores.h"
#include "cli/report_plots.h"
#include "cli/svg_plot.h"
#include "cli/text.h"

namespace contact_shapelets::cli {
namespace {

constexpr std::size_t kTellingShapelets = 3;
constexpr std::size_t kNovelPlots = 6;

constexpr char kStyle[] =
    "body{font:15px/1.5 sans-serif;max-width:860px;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:.6em 0}td,th{padding:.2em .8em;text-align:left;border-bottom:1px "
    "solid #ddd}"
    "td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}td.right{background:#e3f2e6}td.wrong{"
    "background:#fbe3da}"
    "figure{margin:1em 0}figcaption span{margin-right:1.4em}figcaption "
    "i,.mark{display:inline-block;width:.8em;height:.8em;"
    "margin-right:.4em}svg{max-width:100%;height:auto;font:11px sans-serif;display:block}svg text{fill:#333}"
    ".grid{stroke:#e4e4e4}.axis{stroke:#555}"
    ".mark{margin-right:.6em}td:first-child{white-space:nowrap}"
    "h2{margin-top:1.8em;border-bottom:1px solid #bbb}summary{cursor:pointer}";

/// Returns one row of a table. A cell of only digits and signs is a figure.
std::string Row(const std::vector<std::string>& cells) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) {
    const bool figure = !cell.empty() && cell.find_first_not_of("0123456789.-+ ") == std::string::npos;
    row += std::string("<td") + (figure ? " class=\"n\">" : ">") + Escaped(cell) + "</td>";
  }
  return row + "</tr>\n";
}

/// The title of a table's column, and whether the column has figures.
struct Column {
  std::string title;
  bool figures = false;
};

std::string Head(const std::vector<Column>& columns) {
  std::string head = "<tr>";
  for (const Column& column : columns) {
    head += std::string("<th") + (column.figures ? " class=\"n\">" : ">") + Escaped(column.title) + "</th>";
  }
  return head + "</tr>\n";
}

std::string Paragraph(const std::string& text) { return "<p>" + text + "</p>\n"; }

std::string Heading(const std::string& text) { return "<h2>" + Escaped(text) + "</h2>\n"; }

std::vector<std::size_t> NovelEpisodes(const ReportContents& contents) {
  std::vector<std::size_t> novel;
  for (std::size_t index = 0; index < contents.results.size(); ++index) {
    if (contents.results[index].diagnosis.cluster < 0) novel.push_back(index);
  }
  std::sort(novel.begin(), novel.end(), [&contents](std::size_t first, std::size_t second) {
    return contents.results[first].diagnosis.novelty > contents.results[second].diagnosis.novelty;
  });
  return novel;
}

/// Returns the colour class of a cell: right if the event equals the outcome, else wrong. It is empty if the event is
/// the number of a cluster without a name, or `unknown` where no cluster has the outcome's name.
std::string Verdict(const EventScores& scores, const std::string& outcome, const std::string& event) {
  if (event == outcome && event != scores.events().back()) return " right";
  return scores.IsNamed(event) || scores.IsNamed(outcome) ? " wrong" : "";
}

std::string ConfusionTable(const EventScores& scores) {
  std::string table = "<table>\n<tr><th>outcome given \\ event</th>";
  for (const std::string& event : scores.events()) table += "<th class=\"n\">" + Escaped(event) + "</th>";
  table += "</tr>\n";
  for (const std::string& outcome : scores.outcomes()) {
    table += "<tr><th>" + Escaped(outcome) + "</th>";
    for (const std::string& event : scores.events()) {
      const int count = scores.CountOf(outcome, event);
      const std::string verdict = count > 0 ? Verdict(scores, outcome, event) : "";
      table += "<td class=\"n" + verdict + "\">" + std::to_string(count) + "</td>";
    }
    table += "</tr>\n";
  }
  return table + "</table>\n";
}

std::string Summary(const ReportContents& contents) {
  const std::size_t novel = NovelEpisodes(contents).size();
  std::string text =
      Escaped(Count(contents.episodes.size(), "episode") + " of " + Number(MedianDuration(contents.episodes), 2) +
              " s (median) from " + Count(contents.bags.size(), "bag") + ", sorted into " +
              Count(contents.model.clusters.size(), "cluster") + "; " + std::to_string(novel) + " fit none of them.");
  const EventScores scores(contents.model, contents.episodes, NamedEpisodes(contents.results));
  if (scores.episodes() == 0) return Paragraph(text + " The bags have no outcomes to compare with.");
  std::string summary = Paragraph("<b>" + Escaped(scores.Summary()) + "</b>") + ConfusionTable(scores);
  for (const std::string& warning : scores.Warnings()) summary += Paragraph(Escaped(warning));
  return summary + Paragraph(text + " " + Escaped(scores.Indices()));
}

std::string ProvenanceTable(const ReportContents& contents) {
  const core::Model& model = contents.model;
  const core::Provenance& provenance = model.provenance;
  std::vector<std::string> scales;
  for (const double scale : provenance.selected_scales) scales.push_back(Number(scale, 2));
  std::string table = "<table>\n";
  table += Row({"Model", model.id + " in " + contents.model_file});
  table += Row({"Trained on", Count(static_cast<std::size_t>(provenance.training_episodes), "episode") + " of " +
                                  Number(provenance.typical_duration, 2) + " s (median) from " +
                                  Joined(provenance.sources, ", ")});
  table += Row({"Shapelets", std::to_string(model.shapelets.size()) + ", learned by the " + provenance.objective +
                                 " objective with seed " + std::to_string(provenance.seed)});
  table += Row({"Scales", Joined(scales, ", ") + " of the typical duration"});
  table += Row({"Sample period", Number(model.sample_period, 4) + " s"});
  table += Row({"Bags of this report", Joined(contents.bags, ", ")});
  return table + "</table>\n";
}

std::string ClusterTable(const ReportContents& contents) {
  std::string table = "<table>\n" + Head({{"cluster"},
                                          {"event"},
                                          {"in training", true},
                                          {"here", true},
                                          {"of them novel", true},
                                          {"median duration [s]", true},
                                          {"median peak [N]", true},
                                          {"median confidence", true}});
  for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
    const std::vector<std::size_t> members = MembersOf(contents, cluster);
    std::vector<double> durations;
    std::vector<double> peaks;
    std::vector<double> confidences;
    int novel = 0;
    for (const std::size_t member : members) {
      durations.push_back(contents.episodes[member].duration());
      peaks.push_back(contents.series[member].maxCoeff());
      confidences.push_back(contents.results[member].diagnosis.confidence);
      novel += contents.results[member].diagnosis.cluster < 0 ? 1 : 0;
    }
    std::string row = Row({contents.model.EventOf(cluster),
                           std::to_string(contents.model.clusters[static_cast<std::size_t>(cluster)].size),
                           std::to_string(members.size()), std::to_string(novel), Number(Median(durations), 2),
                           Number(Median(peaks), 1), Number(Median(confidences), 2)});
    row.insert(4, "<td><span class=\"mark\" style=\"background:" + ClusterColour(cluster) + "\"></span>" +
                      std::to_string(cluster) + "</td>");
    table += row;
  }
  return table + "</table>\n";
}

std::string ShapeletTable(const ReportContents& contents, const std::vector<Eigen::Index>& shapelets) {
  std::vector<Column> head{{"shapelet", true}, {"length [s]", true}};
  for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
    head.push_back({"mean distance in " + contents.model.EventOf(cluster), true});
  }
  std::string table = "<table>\n" + Head(head);
  for (const Eigen::Index index : shapelets) {
    const core::Shapelet& shapelet = contents.model.shapelets[static_cast<std::size_t>(index)];
    std::vector<std::string> cells{
        std::to_string(index),
        Number(static_cast<double>(shapelet.values.size()) * shapelet.dilation * contents.model.sample_period, 2)};
    for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
      double sum = 0.0;
      const std::vector<std::size_t> members = MembersOf(contents, cluster);
      for (const std::size_t member : members) sum += contents.results[member].features.distances[index];
      cells.push_back(members.empty() ? "none" : Number(sum / static_cast<double>(members.size()), 3));
    }
    table += Row(cells);
  }
  return table + "</table>\n";
}

std::string ClusterSection(const ReportContents& contents, int cluster) {
  const std::vector<std::size_t> members = MembersOf(contents, cluster);
  std::string section = Heading("Cluster " + std::to_string(cluster) + ": " + contents.model.EventOf(cluster));
  if (members.empty()) return section + Paragraph("No episode of these bags is nearest to this cluster.");
  const std::size_t example = TypicalMember(contents, cluster, members);
  section += TypicalPlot(contents, cluster);
  const std::vector<Eigen::Index> shapelets = FindTellingShapelets(contents, cluster, example, kTellingShapelets);
  if (shapelets.empty()) return section + Paragraph("No shapelet tells these episodes from others in these bags.");
  section += Paragraph(
      "The shapelets that tell this cluster from the others best, over its most typical episode, where they "
      "matched: each is scaled to the force there, as the matching does. Their distances are in brackets.");
  section += MatchPlot(contents, example, shapelets);
  section += ShapeletTable(contents, shapelets);
  return section + Paragraph(
                       "A distance of 0 is a perfect match, 1 is none. The nearer to 0 in this cluster and "
                       "the farther in "
                       "the others, the more the shapelet says.");
}

std::string NovelSection(const ReportContents& contents) {
  std::string section = Heading("Novelty");
  section += Paragraph(
      "Distance of each episode from its nearest cluster, over that cluster's limit. Above 1 an episode fits "
      "no cluster: its event is &ldquo;unknown&rdquo;. A slow rise hints at wear or drift.");
  section += NoveltyPlot(contents);
  const std::vector<std::size_t> novel = NovelEpisodes(contents);
  if (novel.empty()) return section + Paragraph("No episode is novel.");
  section += "<table>\n" + Head({{"novel episode"}, {"novelty", true}, {"nearest cluster"}, {"outcome given"}});
  for (const std::size_t index : novel) {
    const core::Diagnosis& diagnosis = contents.results[index].diagnosis;
    section += Row({contents.episodes[index].id, Number(diagnosis.novelty, 2),
                    contents.model.EventOf(diagnosis.nearest_cluster), contents.episodes[index].outcome});
  }
  section += "</table>\n";
  for (std::size_t place = 0; place < std::min(novel.size(), kNovelPlots); ++place) {
    section += NovelPlot(contents, novel[place]);
  }
  return section;
}

std::string EpisodeTable(const ReportContents& contents) {
  std::string table = "<details><summary>All " + Count(contents.episodes.size(), "episode") + "</summary>\n<table>\n";
  table += Head({{"episode"},
                 {"start (UTC)"},
                 {"duration [s]", true},
                 {"outcome given"},
                 {"event"},
                 {"confidence", true},
                 {"novelty", true}});
  for (std::size_t index = 0; index < contents.episodes.size(); ++index) {
    const core::Episode& episode = contents.episodes[index];
    const core::Diagnosis& diagnosis = contents.results[index].diagnosis;
    table += Row({episode.id, DateText(episode.start), Number(episode.duration(), 2), episode.outcome, diagnosis.event,
                  Number(diagnosis.confidence, 2), Number(diagnosis.novelty, 2)});
  }
  return table + "</table>\n</details>\n";
}

}  // namespace

std::string ReportPage(const ReportContents& contents) {
  std::string page =
      kPageStart + Escaped(contents.model.id) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n";
  page += "<h1>Contact report</h1>\n" + Summary(contents);
  page += OverviewPlot(contents) + ClusterTable(contents);
  page += Paragraph(
      "Curves are medians over a cluster's episodes, shifted in time so that each lies best over the most "
      "typical "
      "one: contacts begin at different times.");
  for (int cluster = 0; cluster < static_cast<int>(contents.model.clusters.size()); ++cluster) {
    page += ClusterSection(contents, cluster);
  }
  page += NovelSection(contents);
  page += Heading("Model") + ProvenanceTable(contents);
  page += Heading("Episodes") + EpisodeTable(contents);
  page += Paragraph("All distances to all shapelets are in episodes.csv beside this page.");
  return page + "</body>\n</html>\n";
}

}  // namespace contact_shapelets::cli
