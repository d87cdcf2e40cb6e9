#pragma once
// The distributions of the normal deviate, Student's t and Fisher's F, made of + − × ÷ and square roots only
// (base/maths.h), so that a p-value has the same bits on every machine.

namespace morula {

/// Returns ln Γ(a), a > 0, to within 1e-14 (1 + |ln Γ(a)|): Stirling's series above 16, reached by Γ(a) = Γ(a + 1) / a.
double logGamma(double a);

/// The regularised incomplete beta function
///
///   I_x(a, b) = ∫₀ˣ t^(a−1) (1 − t)^(b−1) dt / B(a, b),   a, b > 0, 0 ≤ x ≤ 1
///
/// by its continued fraction [DLMF 8.17.22], to within 1e-11 of the value for a, b up to 10⁴. `y` is 1 − x, which may
/// be known more exactly than a subtraction would give.
double incompleteBeta(double a, double b, double x, double y);
/// Returns the x with I_x(a, b) = share, 0 < share < 1.
double betaQuantile(double share, double a, double b);

/// Returns P(T > t) of Student's t with `df` > 0 degrees of freedom, which need not be whole.
double studentAbove(double t, double df);
/// Returns P(|T| > |t|).
double studentBeyond(double t, double df);
/// Returns the t with P(T ≤ t) = share, 0 < share < 1.
double studentQuantile(double share, double df);

/// Returns P(F > f) of Fisher's F with these degrees of freedom; 1 for f ≤ 0.
double fisherAbove(double f, double df1, double df2);

/// P(F > f) of noncentral distributions with parameters `lambda` ≥ 0: the mean of central ones with d₁ + 2j, j of
/// Poisson's distribution with mean λ/2, to within 1e-10. Above λ = 1000: ((d₁ + λ)/d₁) F with (d₁ + λ)²/(d₁ + 2λ) and
/// d₂ degrees of freedom, whose numerator has equal mean and variance [Patnaik 1949], to within 0.005.
class NoncentralFisher {
 public:
  NoncentralFisher(double f, double df1, double df2);
  double above(double lambda) const;

 private:
  double f_, df1_, df2_, y_ = 0, central_ = 0, more_ = 0;  // I_x(d₂/2, d₁/2), and the addend of j = 1
};

}  // namespace morula
