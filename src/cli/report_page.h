#pragma once

#include <string>
#include <vector>

#include "contact_shapelets/core/classifier.h"
#include "contact_shapelets/core/episode.h"

/// \file
/// The report on a model and on the episodes that it diagnosed, as one HTML page that needs no other file.

namespace contact_shapelets::cli {

/// The text that each page begins with.
constexpr char kPageStart[] =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Contact report: model ";

/// The contents of a report.
struct ReportContents {
  core::Model model;
  std::string model_file;
  std::vector<std::string> bags;
  std::vector<core::Episode> episodes;        ///< at least one
  std::vector<core::Classification> results;  ///< one per episode
  std::vector<Eigen::VectorXf> series;        ///< their forces [N] at the model's sample period
};

/// Returns the page: a summary, the model's provenance, agreement with the outcomes, the clusters with typical force
/// curves and their most telling shapelets, novel episodes, and a table of all episodes.
std::string ReportPage(const ReportContents& contents);

}  // namespace contact_shapelets::cli
