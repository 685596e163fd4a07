#include "core/model/training_digest.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace contact_shapelets::core {
namespace {

/// Raise this with each change that makes another model from the same input.
constexpr std::uint64_t kAlgorithmVersion = 1;

/// [mN] Limit above every valid force, so that the conversion to an integer cannot overflow.
constexpr double kGreatest = 1e15;

/// FNV-1a of 64 bits over numbers of 8 bytes, lowest byte first on every machine.
class Digest {
 public:
  void Add(std::uint64_t number) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ (number >> (8 * byte) & 0xFFU)) * 1099511628211ULL;
  }
  void AddCount(std::size_t count) { Add(static_cast<std::uint64_t>(count)); }
  void AddNumber(double number) {
    const double without_minus_zero = number == 0.0 ? 0.0 : number;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &without_minus_zero, sizeof(bits));
    Add(bits);
  }
  void AddForce(float force) {
    const double millinewtons = std::clamp(1000.0 * static_cast<double>(force), -kGreatest, kGreatest);
    Add(static_cast<std::uint64_t>(std::llround(millinewtons)));
  }
  std::string Text() const {
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << value_;
    return text.str();
  }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

void AddLearner(const LearnerOptions& options, Digest* digest) {
  digest->AddCount(options.scales.size());
  for (const double scale : options.scales) digest->AddNumber(scale);
  digest->Add(static_cast<std::uint64_t>(options.objective));
  digest->AddNumber(options.repulsion);
  digest->AddNumber(options.diversity);
  digest->AddNumber(options.sparsity);
  digest->AddNumber(options.flat_fraction);
  digest->AddNumber(options.steps);
  digest->AddNumber(options.learning_rate);
  digest->AddNumber(options.batch);
  digest->AddNumber(options.start_windows);
  digest->AddNumber(options.shortest);
}

}  // namespace

std::string TrainingDigest(const std::vector<Episode>& episodes, const TrainerOptions& options) {
  Digest digest;
  digest.Add(kAlgorithmVersion);
  digest.AddNumber(options.clusters);
  AddLearner(options.learner, &digest);
  digest.Add(options.log_distances ? 1U : 0U);
  digest.AddNumber(options.kmeans_restarts);
  digest.AddNumber(options.voters);
  digest.AddNumber(options.random_shapelets);
  digest.AddNumber(options.voting_episodes);
  digest.AddNumber(options.novelty_quantile);
  digest.AddNumber(options.novelty_margin);
  digest.Add(options.seed);
  digest.AddCount(episodes.size());
  if (!episodes.empty()) digest.AddNumber(episodes.front().sample_period);
  for (const Episode& episode : episodes) {
    digest.AddCount(static_cast<std::size_t>(episode.force.size()));
    for (Eigen::Index sample = 0; sample < episode.force.size(); ++sample) digest.AddForce(episode.force[sample]);
  }
  return digest.Text();
}

}  // namespace contact_shapelets::core
