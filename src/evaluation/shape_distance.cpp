#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "evaluation/k_shape.h"

namespace contact_shapelets::evaluation {
namespace {

/// FFTW's planner must not run in two threads at the same time.
std::mutex& PlannerMutex() {
  static std::mutex mutex;
  return mutex;
}

/// Returns the least power of two that holds all shifts of two series without overlap of its ends.
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

double ShapeComparer::Correlate(const Eigen::Ref<const Eigen::RowVectorXcd>& x,
                                const Eigen::Ref<const Eigen::RowVectorXcd>& y) const {
  Eigen::Map<Eigen::RowVectorXcd> spectrum(reinterpret_cast<std::complex<double>*>(plans_->spectrum),
                                           plans_->size / 2 + 1);
  spectrum = x.cwiseProduct(y.conjugate());
  fftw_execute(plans_->backward);
  const int negative = plans_->length - 1;
  const Eigen::Map<const Eigen::ArrayXd> values(plans_->values, plans_->size);
  const double most = values.head(plans_->length).maxCoeff();
  return negative > 0 ? std::max(most, values.tail(negative).maxCoeff()) : most;
}

double ShapeComparer::Distance(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                               const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const {
  if (x_norm <= 0.0 || y_norm <= 0.0) return 1.0;
  return 1.0 - Correlate(x, y) / (x_norm * y_norm * plans_->size);
}

ShapeDistance ShapeComparer::Compare(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                                     const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const {
  ShapeDistance best;
  if (x_norm <= 0.0 || y_norm <= 0.0) return best;
  const double scale = x_norm * y_norm * plans_->size;
  const double most = Correlate(x, y);
  best.distance = 1.0 - most / scale;
  // Rounding must not decide between shifts that are equally good.
  constexpr double kRounding = 1e-12;
  const double enough = most - kRounding * scale;
  while (best.shift < plans_->length) {
    if (plans_->values[best.shift] >= enough) return best;
    if (best.shift > 0 && plans_->values[plans_->size - best.shift] >= enough) break;
    ++best.shift;
  }
  best.shift = -best.shift;
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

}  // namespace contact_shapelets::evaluation
