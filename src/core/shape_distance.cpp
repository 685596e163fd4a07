#include <fftw3.h>

#include <cmath>
#include <mutex>
#include <stdexcept>

#include "contact_shapelets/core/k_shape.h"

namespace contact_shapelets::core {
namespace {

/// FFTW makes plans on one thread at a time only.
std::mutex& PlannerMutex() {
  static std::mutex mutex;
  return mutex;
}

/// The least power of two that holds all shifts of two series without wrapping round.
int TransformLength(int length) {
  int transform = 1;
  while (transform < 2 * length - 1) transform *= 2;
  return transform;
}

}  // namespace

struct ShapeComparer::Plans {
  explicit Plans(int series_length)
      : length(series_length),
        size(TransformLength(series_length)),
        values(fftw_alloc_real(static_cast<std::size_t>(size))),
        spectrum(fftw_alloc_complex(static_cast<std::size_t>(size / 2 + 1))) {
    const std::lock_guard<std::mutex> lock(PlannerMutex());
    forward = fftw_plan_dft_r2c_1d(size, values, spectrum, FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_1d(size, spectrum, values, FFTW_ESTIMATE);
  }
  ~Plans() {
    const std::lock_guard<std::mutex> lock(PlannerMutex());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
    fftw_free(values);
    fftw_free(spectrum);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  int length;
  int size;
  double* values;
  fftw_complex* spectrum;
  fftw_plan forward;
  fftw_plan backward;
};

ShapeComparer::ShapeComparer(int length) {
  if (length < 1) throw std::invalid_argument("shapes must have at least 1 value");
  plans_ = std::make_unique<Plans>(length);
}

ShapeComparer::~ShapeComparer() = default;

Eigen::MatrixXcd ShapeComparer::Spectra(const Eigen::Ref<const Eigen::MatrixXd>& series) const {
  Eigen::MatrixXcd spectra(series.rows(), plans_->size / 2 + 1);
  Eigen::Map<Eigen::RowVectorXd> values(plans_->values, plans_->size);
  const Eigen::Map<const Eigen::RowVectorXcd> spectrum(reinterpret_cast<const std::complex<double>*>(plans_->spectrum),
                                                       spectra.cols());
  for (Eigen::Index row = 0; row < series.rows(); ++row) {
    values.setZero();
    values.head(series.cols()) = series.row(row);
    fftw_execute(plans_->forward);
    spectra.row(row) = spectrum;
  }
  return spectra;
}

ShapeDistance ShapeComparer::Compare(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                                     const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const {
  ShapeDistance best;
  if (x_norm <= 0.0 || y_norm <= 0.0) return best;
  Eigen::Map<Eigen::RowVectorXcd> spectrum(reinterpret_cast<std::complex<double>*>(plans_->spectrum),
                                           plans_->size / 2 + 1);
  spectrum = x.cwiseProduct(y.conjugate());
  fftw_execute(plans_->backward);
  // The transforms' rounding must not choose between shifts that are equally good.
  constexpr double kRounding = 1e-12;
  const double scale = 1.0 / (x_norm * y_norm * plans_->size);
  double similarity = plans_->values[0] * scale;
  for (int shift = 1; shift < plans_->length; ++shift) {
    for (const int signed_shift : {shift, -shift}) {
      const double value = plans_->values[signed_shift > 0 ? shift : plans_->size - shift] * scale;
      if (value <= similarity + kRounding) continue;
      similarity = value;
      best.shift = signed_shift;
    }
  }
  best.distance = 1.0 - similarity;
  return best;
}

ShapeDistance CompareShapes(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& y) {
  if (x.size() != y.size() || x.size() == 0) throw std::invalid_argument("shapes must have one length, at least 1");
  const ShapeComparer comparer(static_cast<int>(x.size()));
  return comparer.Compare(comparer.Spectra(x.transpose()), x.norm(), comparer.Spectra(y.transpose()), y.norm());
}

Eigen::VectorXd Shifted(const Eigen::Ref<const Eigen::VectorXd>& series, int shift) {
  const Eigen::Index kept = series.size() - std::abs(shift);
  Eigen::VectorXd shifted = Eigen::VectorXd::Zero(series.size());
  if (kept <= 0) return shifted;
  if (shift >= 0) {
    shifted.tail(kept) = series.head(kept);
  } else {
    shifted.head(kept) = series.tail(kept);
  }
  return shifted;
}

}  // namespace contact_shapelets::core
