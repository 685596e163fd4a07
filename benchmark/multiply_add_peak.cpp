#include "multiply_add_peak.h"

#include <benchmark/benchmark.h>

#include <cstring>

namespace contact_shapelets {
namespace {

// Clang refuses inlined functions with wider registers than those that the program is built for.
#if defined(__x86_64__) && !defined(__clang__)
/// The callers have wider instruction sets than the rest of the program, so it must be inlined into them.
template <int Lanes>
inline __attribute__((always_inline)) double Peak(int rounds) {
  typedef float Vector __attribute__((vector_size(Lanes * sizeof(float))));
  // Enough chains to hide the latency of a multiply-add, few enough for sixteen registers.
  Vector a = {}, b = {}, c = {}, d = {}, e = {}, f = {}, g = {}, h = {}, i = {}, j = {};
  const Vector factor = Vector{} + 0.999F;
  const Vector term = Vector{} + 1e-6F;
  for (int round = 0; round < rounds; ++round) {
    a = a * factor + term, b = b * factor + term, c = c * factor + term, d = d * factor + term, e = e * factor + term;
    f = f * factor + term, g = g * factor + term, h = h * factor + term, i = i * factor + term, j = j * factor + term;
    // Without this the compiler would merge the equal chains into one.
    __asm__ volatile("" : "+x"(a), "+x"(b), "+x"(c), "+x"(d), "+x"(e));
    __asm__ volatile("" : "+x"(f), "+x"(g), "+x"(h), "+x"(i), "+x"(j));
  }
  const Vector sum = a + b + c + d + e + f + g + h + i + j;
  float values[Lanes];
  std::memcpy(values, &sum, sizeof(values));
  benchmark::DoNotOptimize(values[0]);
  return 10.0 * Lanes * rounds;
}

__attribute__((target("avx512f,fma"))) double Avx512Peak(int rounds) { return Peak<16>(rounds); }
__attribute__((target("avx2,fma"))) double Avx2Peak(int rounds) { return Peak<8>(rounds); }
double BaselinePeak(int rounds) { return Peak<4>(rounds); }
#endif

}  // namespace

double MultiplyAdds(const char* instruction_set, int rounds) {
#if defined(__x86_64__) && !defined(__clang__)
  if (std::strcmp(instruction_set, "avx512") == 0) return Avx512Peak(rounds);
  if (std::strcmp(instruction_set, "avx2") == 0) return Avx2Peak(rounds);
  return BaselinePeak(rounds);
#else
  static_cast<void>(instruction_set);
  static_cast<void>(rounds);
  return 0.0;
#endif
}

}  // namespace contact_shapelets
