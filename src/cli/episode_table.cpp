#include "cli/episode_table.h"

#include <iomanip>
#include <stdexcept>

#include "cli/text.h"
#include "core/numerics/parallel.h"

namespace contact_shapelets::cli {
namespace {

/// Returns a time with all nine decimals. A double at today's date has fewer.
std::string ExactSeconds(core::Nanoseconds time) {
  const std::string decimals = std::to_string(time % 1'000'000'000);
  return std::to_string(time / 1'000'000'000) + "." + std::string(9 - decimals.size(), '0') + decimals;
}

}  // namespace

std::vector<core::Classification> ClassifyAll(const core::Classifier& classifier,
                                              const std::vector<core::Episode>& episodes, int threads) {
  std::vector<core::Classification> results(episodes.size());
  core::ParallelFor(static_cast<int>(episodes.size()), core::ThreadCount(threads), [&](int index) {
    const core::Episode& episode = episodes[static_cast<std::size_t>(index)];
    try {
      results[static_cast<std::size_t>(index)] = classifier.Classify(episode);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("episode " + episode.id + ": " + error.what());
    }
  });
  return results;
}

void WriteCsv(const std::vector<core::Episode>& episodes, const std::vector<core::Classification>& results,
              std::ostream* file) {
  *file << kTableStart << ",complete";
  const Eigen::Index shapelets = results.empty() ? 0 : results.front().features.distances.size();
  for (Eigen::Index k = 0; k < shapelets; ++k) *file << ",d" << k;
  *file << '\n' << std::setprecision(9);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const core::Episode& episode = episodes[index];
    const core::Diagnosis& diagnosis = results[index].diagnosis;
    *file << CsvField(episode.id) << ',' << ExactSeconds(episode.start) << ',' << episode.duration() << ','
          << episode.force.size() << ',' << CsvField(episode.outcome) << ',' << diagnosis.cluster << ','
          << CsvField(diagnosis.event) << ',' << diagnosis.confidence << ',' << diagnosis.novelty << ','
          << (episode.complete ? "true" : "false");
    for (Eigen::Index k = 0; k < shapelets; ++k) *file << ',' << results[index].features.distances[k];
    *file << '\n';
  }
}

}  // namespace contact_shapelets::cli
