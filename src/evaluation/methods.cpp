#include "evaluation/methods.h"

#include <algorithm>
#include <stdexcept>

#include "core/numerics/series.h"
#include "evaluation/data_set.h"
#include "evaluation/dictionary.h"
#include "evaluation/dtw.h"
#include "evaluation/feature_clusterer.h"
#include "evaluation/k_shape.h"
#include "evaluation/stne_clusterer.h"
#include "evaluation/udfs.h"
#include "evaluation/uslm.h"

namespace contact_shapelets::evaluation {
namespace {

/// K-means on the z-normalised series themselves.
class RawClusterer : public FeatureClusterer {
 public:
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override {
    return EqualLengthRows(series, length_);
  }

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& train, int /*clusters*/, std::uint64_t /*seed*/) override {
    length_ = core::MedianLength(train);
  }

 private:
  int length_ = 0;
};

/// Returns the number of neighbours, 1 to 999, in a name such as "udfs_k8"; 0 if the name has another form.
int UdfsNeighbours(const std::string& name) {
  const std::string prefix = "udfs_k";
  const std::string digits = name.substr(std::min(prefix.size(), name.size()));
  const bool number =
      !digits.empty() && digits.size() <= 3 && digits.find_first_not_of("0123456789") == std::string::npos;
  return name.compare(0, prefix.size(), prefix) == 0 && number ? std::stoi(digits) : 0;
}

}  // namespace

const std::vector<std::string>& ClustererNames() {
  static const std::vector<std::string> names{"kmeans", "dtw",        "udfs",    "kshape",
                                              "uslm",   "dictionary", "nn_stne", "nn_stne_paper"};
  return names;
}

std::unique_ptr<Clusterer> MakeClusterer(const std::string& name, const core::TrainerOptions& options) {
  if (name == "kmeans") return std::make_unique<RawClusterer>();
  if (name == "udfs") return std::make_unique<UdfsClusterer>(UdfsOptions{});
  if (const int neighbours = UdfsNeighbours(name); neighbours > 0) {
    UdfsOptions udfs;
    udfs.neighbours = neighbours;
    return std::make_unique<UdfsClusterer>(udfs);
  }
  if (name == "dtw") return std::make_unique<DtwClusterer>(DtwOptions{});
  if (name == "dictionary") return std::make_unique<DictionaryClusterer>(DictionaryOptions{});
  if (name == "kshape") return std::make_unique<KShapeClusterer>();
  if (name == "uslm") return std::make_unique<UslmClusterer>(UslmOptions{});
  if (name == "nn_stne") return std::make_unique<StneClusterer>(options);
  if (name == "nn_stne_paper") return std::make_unique<StneClusterer>(core::PaperOptions());
  std::string names;
  for (const std::string& known : ClustererNames()) names += known + ", ";
  throw std::invalid_argument("there is no method " + name + "; there are " + names + "and udfs_k1 to udfs_k999");
}

}  // namespace contact_shapelets::evaluation
