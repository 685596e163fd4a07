#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// \file
/// Operations of the inner loops on one vector of `Lanes` floats. It is GCC's vector code; single instructions are
/// named only if the compiler does not find them.

namespace contact_shapelets::core::tile {
namespace {

template <int Lanes>
struct VectorOf {
  typedef float Floats __attribute__((vector_size(Lanes * sizeof(float))));
  typedef int Integers __attribute__((vector_size(Lanes * sizeof(int))));
  typedef double Doubles __attribute__((vector_size(Lanes / 2 * sizeof(double))));
  /// True if there are 32 vector registers and not only 16.
#if defined(__AVX512VL__)
  static constexpr bool kManyRegisters = true;
#else
  static constexpr bool kManyRegisters = false;
#endif

  template <typename Type>
  static Type Load(const void* from) {
    Type vector;
    __builtin_memcpy(&vector, from, sizeof(vector));
    return vector;
  }
  template <typename Type>
  static void Store(void* to, Type vector) {
    __builtin_memcpy(to, &vector, sizeof(vector));
  }

  /// Loads a vector that several instructions use. The empty instruction makes the compiler keep it in a register
  /// instead of loading it anew for each of them.
  static Floats LoadOnce(const float* from) {
    Floats vector = Load<Floats>(from);
#if defined(__x86_64__)
    __asm__("" : "+v"(vector));
#endif
    return vector;
  }
  /// The same for one value in all lanes.
  static Floats Spread(float value) {
    Floats vector = Floats{} + value;
#if defined(__x86_64__)
    __asm__("" : "+v"(vector));
#endif
    return vector;
  }

  static Doubles LoadDoubles(const float* from) {
    double values[Lanes / 2];
    for (int lane = 0; lane < Lanes / 2; ++lane) values[lane] = static_cast<double>(from[lane]);
    return Load<Doubles>(values);
  }

  static Floats Larger(Floats one, Floats other) { return one > other ? one : other; }

  /// Returns the signs of the lanes, one bit each.
  static unsigned Signs(Integers vector) {
#if defined(__AVX512DQ__)
    if constexpr (Lanes == 16) return _mm512_movepi32_mask((__m512i)vector);
#endif
#if defined(__AVX__)
    if constexpr (Lanes == 8) return static_cast<unsigned>(_mm256_movemask_ps((__m256)vector));
#endif
#if defined(__x86_64__)
    if constexpr (Lanes == 4) return static_cast<unsigned>(_mm_movemask_ps((__m128)vector));
#endif
    unsigned lanes[Lanes];
    Store(lanes, vector);
    unsigned bits = 0;
    for (int lane = 0; lane < Lanes; ++lane) bits |= (lanes[lane] >> 31) << lane;
    return bits;
  }

  /// Returns the largest lane.
  static float Largest(Floats vector) {
#if defined(__AVX512DQ__)
    if constexpr (Lanes == 16) {
      const auto whole = (__m512)vector;
      // Without a mask, the compiler warns of a variable that its own header leaves undefined. So does the cast to a
      // half.
      const __m256 lower = _mm512_maskz_extractf32x8_ps(0xFF, whole, 0);
      const __m256 upper = _mm512_maskz_extractf32x8_ps(0xFF, whole, 1);
      return VectorOf<8>::Largest((typename VectorOf<8>::Floats)_mm256_max_ps(lower, upper));
    }
#endif
#if defined(__AVX__)
    if constexpr (Lanes == 8) {
      const auto whole = (__m256)vector;
      const __m128 half = _mm_max_ps(_mm256_castps256_ps128(whole), _mm256_extractf128_ps(whole, 1));
      return VectorOf<4>::Largest((typename VectorOf<4>::Floats)half);
    }
#endif
#if defined(__x86_64__)
    if constexpr (Lanes == 4) {
      const auto whole = (__m128)vector;
      const __m128 half = _mm_max_ps(whole, _mm_movehl_ps(whole, whole));
      return _mm_cvtss_f32(_mm_max_ss(half, _mm_shuffle_ps(half, half, 1)));
    }
#endif
    float lanes[Lanes];
    Store(lanes, vector);
    float largest = lanes[0];
    for (const float lane : lanes) largest = lane > largest ? lane : largest;
    return largest;
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
