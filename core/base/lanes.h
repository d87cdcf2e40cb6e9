// Lanes: several cells side by side. Only this file and lane_*.h know SIMD, and only *_kernels.cpp files include them,
// by way of *_kernel.h. Each is compiled once per instruction set, with MORULA_ISA (a namespace) and MORULA_WIDTH set
// by the build, so that no inline function of one set can be linked into another.
//
// The determinism contract: every operation here is one IEEE 754 operation per lane, rounded to nearest. So lane k of
// any width computes what a double would. No fused multiply-add, no approximate reciprocal, no reassociation.
#pragma once
#include <cstdint>

#if MORULA_WIDTH > 1
#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif
#endif

#if defined(__FAST_MATH__)
#error "fast-math changes results: see core/README.md, 'Same bits'"
#endif

#define MORULA_INLINE inline __attribute__((always_inline))

namespace morula::MORULA_ISA {

constexpr int width = MORULA_WIDTH;

// The numbers of a scene: floats where the build says so, doubles else.
#if defined(MORULA_SINGLE)
using Real = float;
typedef std::int32_t MaskReal;
constexpr bool single = true;
#else
using Real = double;
typedef std::int64_t MaskReal;
constexpr bool single = false;
#endif

#if MORULA_WIDTH == 1 && !defined(MORULA_SINGLE)

using Lanes = double;
using Mask = bool;
MORULA_INLINE Lanes load(const double* p) { return *p; }
MORULA_INLINE void store(double* p, Lanes a) { *p = a; }
MORULA_INLINE Lanes sqrt(Lanes a) { return __builtin_sqrt(a); }
MORULA_INLINE Lanes abs(Lanes a) { return __builtin_fabs(a); }
MORULA_INLINE Lanes select(Mask m, Lanes a, Lanes b) { return m ? a : b; }
MORULA_INLINE bool any(Mask m) { return m; }
MORULA_INLINE unsigned bits(Mask m) { return m; }

#else

// A lane of one float is a vector as well: as a bare float it would be promoted to double on the way.
typedef Real RawLanes __attribute__((vector_size(MORULA_WIDTH * sizeof(Real))));
typedef MaskReal RawMask __attribute__((vector_size(MORULA_WIDTH * sizeof(Real))));
typedef double WideLanes __attribute__((vector_size(MORULA_WIDTH * sizeof(double))));

// AVX-512 has registers for masks. From plain comparisons gcc would make vectors, and masks of these vectors.
#if defined(__x86_64__) && !defined(MORULA_SINGLE) && MORULA_WIDTH == 8
#define MORULA_COMPARE(a, b, how, ordered) \
  { _mm512_cmp_pd_mask((__m512d)a.v, (__m512d)b.v, ordered) }
#define MORULA_MASK_REGISTERS
typedef __mmask8 RawBits;
#else
#define MORULA_COMPARE(a, b, how, ordered) \
  { a.v how b.v }
typedef RawMask RawBits;
#endif

struct Mask {
  RawBits v;
  friend MORULA_INLINE Mask operator&(Mask a, Mask b) { return {static_cast<RawBits>(a.v & b.v)}; }
};

struct Lanes {
  RawLanes v;
  Lanes() = default;
  MORULA_INLINE Lanes(RawLanes raw) : v(raw) {}
  MORULA_INLINE Lanes(double a) : v(static_cast<Real>(a) - RawLanes{}) {}  // in every lane; −0 stays −0
  friend MORULA_INLINE Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend MORULA_INLINE Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend MORULA_INLINE Lanes operator-(Lanes a) { return -a.v; }
  friend MORULA_INLINE Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend MORULA_INLINE Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  MORULA_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
  MORULA_INLINE Lanes& operator-=(Lanes b) { return *this = *this - b; }
  friend MORULA_INLINE Mask operator>(Lanes a, Lanes b) { return MORULA_COMPARE(a, b, >, _CMP_GT_OS); }
  friend MORULA_INLINE Mask operator<(Lanes a, Lanes b) { return MORULA_COMPARE(a, b, <, _CMP_LT_OS); }
  friend MORULA_INLINE Mask operator!=(Lanes a, Lanes b) { return MORULA_COMPARE(a, b, !=, _CMP_NEQ_UQ); }
};

MORULA_INLINE Lanes load(const Real* p) {
  Lanes a;
  __builtin_memcpy(&a.v, p, sizeof a.v);
  return a;
}
MORULA_INLINE void store(Real* p, Lanes a) { __builtin_memcpy(p, &a.v, sizeof a.v); }
#if defined(MORULA_SINGLE)
// Loads values of whole cells, which are always kept in doubles.
MORULA_INLINE Lanes load(const double* p) {
  WideLanes a;
  __builtin_memcpy(&a, p, sizeof a);
  return __builtin_convertvector(a, RawLanes);
}
MORULA_INLINE void store(double* p, Lanes a) {
  const WideLanes wide = __builtin_convertvector(a.v, WideLanes);
  __builtin_memcpy(p, &wide, sizeof wide);
}
#endif

MORULA_INLINE Lanes sqrt(Lanes a) {
#if defined(MORULA_SINGLE)
#if defined(__x86_64__) && MORULA_WIDTH == 4
  return (RawLanes)_mm_sqrt_ps((__m128)a.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 8
  return (RawLanes)_mm256_sqrt_ps((__m256)a.v);
#elif defined(__aarch64__) && MORULA_WIDTH == 4
  return (RawLanes)vsqrtq_f32((float32x4_t)a.v);
#elif defined(__wasm_simd128__) && MORULA_WIDTH == 4
  return (RawLanes)wasm_f32x4_sqrt((v128_t)a.v);
#else
  for (int i = 0; i < MORULA_WIDTH; ++i) a.v[i] = __builtin_sqrtf(a.v[i]);
  return a;
#endif
#elif defined(__x86_64__) && MORULA_WIDTH == 2
  return (RawLanes)_mm_sqrt_pd((__m128d)a.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 4
  return (RawLanes)_mm256_sqrt_pd((__m256d)a.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 8
  return (RawLanes)_mm512_sqrt_pd((__m512d)a.v);
#elif defined(__aarch64__) && MORULA_WIDTH == 2
  return (RawLanes)vsqrtq_f64((float64x2_t)a.v);
#elif defined(__wasm_simd128__) && MORULA_WIDTH == 2
  return (RawLanes)wasm_f64x2_sqrt((v128_t)a.v);
#else
  for (int i = 0; i < MORULA_WIDTH; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
  return a;
#endif
}

/// Clears the sign, which is the first bit.
MORULA_INLINE Lanes abs(Lanes a) {
  constexpr MaskReal sign = static_cast<MaskReal>(1ULL << (8 * sizeof(MaskReal) - 1));
  return (RawLanes)((RawMask)a.v & ~(sign + RawMask{}));
}
MORULA_INLINE Lanes select(Mask m, Lanes a, Lanes b) {
#if defined(MORULA_MASK_REGISTERS)
  return (RawLanes)_mm512_mask_blend_pd(m.v, (__m512d)b.v, (__m512d)a.v);
#else
  return m.v ? a.v : b.v;
#endif
}

/// Returns one bit per lane: bit i for lane i.
MORULA_INLINE unsigned bits(Mask m) {
#if defined(MORULA_SINGLE) && defined(__x86_64__) && MORULA_WIDTH == 4
  return _mm_movemask_ps((__m128)m.v);
#elif defined(MORULA_SINGLE) && defined(__x86_64__) && MORULA_WIDTH == 8
  return _mm256_movemask_ps((__m256)m.v);
#elif !defined(MORULA_SINGLE) && defined(__x86_64__) && MORULA_WIDTH == 2
  return _mm_movemask_pd((__m128d)m.v);
#elif !defined(MORULA_SINGLE) && defined(__x86_64__) && MORULA_WIDTH == 4
  return _mm256_movemask_pd((__m256d)m.v);
#elif defined(MORULA_MASK_REGISTERS)
  return m.v;
#elif defined(MORULA_SINGLE) && defined(__wasm_simd128__) && MORULA_WIDTH == 4
  return wasm_i32x4_bitmask((v128_t)m.v);
#elif !defined(MORULA_SINGLE) && defined(__wasm_simd128__) && MORULA_WIDTH == 2
  return wasm_i64x2_bitmask((v128_t)m.v);
#else
  unsigned b = 0;
  for (int i = 0; i < MORULA_WIDTH; ++i) b |= unsigned(m.v[i] & 1) << i;
  return b;
#endif
}

MORULA_INLINE bool any(Mask m) { return bits(m) != 0; }

#endif

/// A number to add to a divisor: keeps quotients finite where a length is 0, and is below rounding everywhere else.
constexpr double tiny = single ? 1e-30 : 1e-280;

// x86 has one instruction for min and one for max. gcc often makes a comparison and a blend, which take longer.
#if defined(__x86_64__) && !defined(MORULA_SINGLE) && MORULA_WIDTH == 8
#define MORULA_X86_PACKED(operation, a, b) (RawLanes) _mm512_##operation##_pd((__m512d)a.v, (__m512d)b.v)
#elif defined(__x86_64__) && !defined(MORULA_SINGLE) && MORULA_WIDTH == 4
#define MORULA_X86_PACKED(operation, a, b) (RawLanes) _mm256_##operation##_pd((__m256d)a.v, (__m256d)b.v)
#endif

/// Returns the smaller number; b where a and b do not compare (as x86's minpd).
MORULA_INLINE Lanes min(Lanes a, Lanes b) {
#if defined(MORULA_X86_PACKED)
  return MORULA_X86_PACKED(min, a, b);
#else
  return select(a < b, a, b);
#endif
}

/// Returns the larger number; b where a and b do not compare (as x86's maxpd).
MORULA_INLINE Lanes max(Lanes a, Lanes b) {
#if defined(MORULA_X86_PACKED)
  return MORULA_X86_PACKED(max, a, b);
#else
  return select(a > b, a, b);
#endif
}

}  // namespace morula::MORULA_ISA
