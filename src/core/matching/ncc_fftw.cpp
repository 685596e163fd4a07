#include "core/matching/ncc_fftw.h"

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace contact_shapelets::core {
namespace {

struct FftwFree {
  void operator()(void* memory) const { fftwf_free(memory); }
};
struct PlanDestroy {
  void operator()(fftwf_plan plan) const;
};
using Reals = std::unique_ptr<float[], FftwFree>;
using Spectrum = std::unique_ptr<std::complex<float>[], FftwFree>;
using Plan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, PlanDestroy>;

/// FFTW's planner is its only part that threads must not run at the same time.
std::mutex& PlannerMutex() {
  static std::mutex mutex;
  return mutex;
}

void PlanDestroy::operator()(fftwf_plan plan) const {
  const std::lock_guard<std::mutex> lock(PlannerMutex());
  fftwf_destroy_plan(plan);
}

fftwf_complex* Raw(std::complex<float>* values) { return reinterpret_cast<fftwf_complex*>(values); }

Spectrum AllocateSpectrum(int bins) {
  return Spectrum(reinterpret_cast<std::complex<float>*>(fftwf_alloc_complex(static_cast<std::size_t>(bins))));
}

/// Returns the smallest number >= `least` without prime factors above 5. FFTW is fast at such sizes.
int TransformSize(int least) {
  for (int size = least;; ++size) {
    int rest = size;
    for (const int factor : {2, 3, 5}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return size;
  }
}

}  // namespace

struct FftwMatcher::Plans {
  explicit Plans(const ShapeletSet& shapelets);

  void Correlate(const std::complex<float>* shapelet);
  void Offer(int window, Match* match) const;

  int length;
  int size;
  int bins;
  Reals values;      ///< a window, then its correlation with a shapelet
  Spectrum window;   ///< spectrum of the window
  Spectrum product;  ///< spectrum of the correlation
  Plan forward;
  Plan backward;
  std::vector<Spectrum> shapelets;  ///< conjugated, with all scale factors; null if the shapelet is constant
};

FftwMatcher::Plans::Plans(const ShapeletSet& set)
    : length(set.length()),
      size(TransformSize(2 * length - 1)),
      bins(size / 2 + 1),
      values(fftwf_alloc_real(static_cast<std::size_t>(size))),
      window(AllocateSpectrum(bins)),
      product(AllocateSpectrum(bins)) {
  {
    const std::lock_guard<std::mutex> lock(PlannerMutex());
    forward.reset(fftwf_plan_dft_r2c_1d(size, values.get(), Raw(window.get()), FFTW_MEASURE | FFTW_PRESERVE_INPUT));
    backward.reset(fftwf_plan_dft_c2r_1d(size, Raw(product.get()), values.get(), FFTW_MEASURE | FFTW_DESTROY_INPUT));
  }
  if (!forward || !backward) throw std::runtime_error("FFTW has no plan for a transform");
  const float scale = 1.0F / (static_cast<float>(length) * static_cast<float>(size));
  for (int k = 0; k < set.count(); ++k) {
    shapelets.emplace_back();
    if (set.normalised().col(k).isZero(0.0F)) continue;
    std::copy_n(set.normalised().col(k).data(), length, values.get());
    std::fill(values.get() + length, values.get() + size, 0.0F);
    fftwf_execute(forward.get());
    shapelets.back() = AllocateSpectrum(bins);
    std::transform(window.get(), window.get() + bins, shapelets.back().get(),
                   [scale](const std::complex<float>& bin) { return scale * std::conj(bin); });
  }
}

void FftwMatcher::Plans::Correlate(const std::complex<float>* shapelet) {
  // Eigen's product is faster than that of std::complex, which checks for infinities.
  using Bins = Eigen::Map<Eigen::ArrayXcf>;
  using ConstantBins = Eigen::Map<const Eigen::ArrayXcf>;
  Bins(product.get(), bins) = ConstantBins(window.get(), bins) * ConstantBins(shapelet, bins);
  fftwf_execute(backward.get());
}

void FftwMatcher::Plans::Offer(int index, Match* match) const {
  // Shift w is at index w, or at size + w if it is negative.
  const Eigen::Map<const Eigen::ArrayXf> ahead(values.get(), length);
  const Eigen::Map<const Eigen::ArrayXf> behind(values.get() + size - (length - 1), length - 1);
  if (std::max(ahead.maxCoeff(), behind.maxCoeff()) <= match->similarity) return;
  Eigen::Index ahead_at = 0;
  Eigen::Index behind_at = 0;
  const float most_ahead = ahead.maxCoeff(&ahead_at);
  const float most_behind = behind.maxCoeff(&behind_at);
  if (most_ahead >= most_behind) {
    *match = {most_ahead, index, static_cast<int>(ahead_at)};
  } else {
    *match = {most_behind, index, static_cast<int>(behind_at) - (length - 1)};
  }
}

FftwMatcher::FftwMatcher(const ShapeletSet& shapelets) : plans_(std::make_unique<Plans>(shapelets)) {}
FftwMatcher::~FftwMatcher() = default;
FftwMatcher::FftwMatcher(FftwMatcher&&) noexcept = default;
FftwMatcher& FftwMatcher::operator=(FftwMatcher&&) noexcept = default;

std::vector<Match> FftwMatcher::BestMatches(const WindowSet& windows) {
  Plans& plans = *plans_;
  if (windows.length() != plans.length) throw std::invalid_argument("windows and shapelets differ in length");
  std::vector<Match> matches(plans.shapelets.size());
  for (int index = 0; index < windows.window_count(); ++index) {
    if (windows.IsFlat(index)) continue;
    Eigen::Map<Eigen::VectorXf>(plans.values.get(), plans.length) = windows.NormalisedWindow(index);
    std::fill(plans.values.get() + plans.length, plans.values.get() + plans.size, 0.0F);
    fftwf_execute(plans.forward.get());
    for (std::size_t k = 0; k < matches.size(); ++k) {
      if (!plans.shapelets[k]) continue;
      plans.Correlate(plans.shapelets[k].get());
      plans.Offer(index, &matches[k]);
    }
  }
  return matches;
}

}  // namespace contact_shapelets::core
