// Distributions against closed forms; tests/scipy compares them with SciPy.
#include "statistics/distributions.h"

#include <cmath>

#include "catch.h"
#include "worst.h"

using namespace morula;

TEST_CASE("ln Γ of whole and half numbers is what products give") {
  Worst error;
  double factorial = 0, half = 0.5 * std::log(M_PI);  // ln Γ(1), ln Γ(½)
  for (int n = 1; n < 400; ++n) {
    error.see(std::abs(logGamma(n) - factorial) / (1 + factorial));
    error.see(std::abs(logGamma(n - 0.5) - half) / (1 + std::abs(half)));
    factorial += std::log(n), half += std::log(n - 0.5);
  }
  CHECK(error < 1e-14);
}

TEST_CASE("Student's t has the closed forms of 1, 2 and 4 degrees of freedom") {
  Worst error;
  for (double t = -30; t <= 30; t += 0.37) {
    error.see(std::abs(studentAbove(t, 1) - (0.5 - std::atan(t) / M_PI)));
    error.see(std::abs(studentAbove(t, 2) - (0.5 - 0.5 * t / std::sqrt(2 + t * t))));
    const double s = t / std::sqrt(4 + t * t);
    error.see(std::abs(studentAbove(t, 4) - (0.5 - 0.25 * s * (3 - s * s))));
  }
  CHECK(error < 1e-14);
  // Far out the tail itself is accurate, not only its difference from 0: P(T > t) ≈ 1/(π t) for one degree of freedom.
  CHECK(studentAbove(1e8, 1) == Approx(1 / (M_PI * 1e8)).epsilon(1e-12));
  CHECK(studentBeyond(INFINITY, 3) == 0);
  CHECK(studentAbove(0, 7) == 0.5);
}

TEST_CASE("Fisher's F of 1 and n degrees of freedom is the square of Student's t, and of 2 has a closed form") {
  Worst error;
  for (const double n : {1., 2., 5., 9.5, 40., 1000.})
    for (double t = 0.1; t < 20; t *= 1.7) {
      error.see(std::abs(fisherAbove(t * t, 1, n) / studentBeyond(t, n) - 1));
      error.see(std::abs(fisherAbove(t, 2, n) / std::pow(1 + 2 * t / n, -0.5 * n) - 1));
    }
  CHECK(error < 1e-11);
  CHECK(fisherAbove(0, 3, 4) == 1);
}

TEST_CASE("Student's distribution comes to the normal one with many degrees of freedom") {
  CHECK(studentQuantile(0.975, 1e6) == Approx(1.959963984540054).epsilon(3e-6));  // the difference is z³/4 df
}

TEST_CASE(
    "The noncentral F distribution is what can be written down for two degrees of freedom, and its "
    "approximation is near") {
  for (const double lambda : {0., 0.3, 5., 60., 900.})
    for (const double f : {0.1, 1., 7., 300.}) {
      const double y2 = f / (1 + f), y4 = f / (2 + f),
                   mu = 0.5 * lambda;  // for 2 and 2, and for 2 and 4 degrees of freedom
      INFO("λ " << lambda << ", F " << f);
      CHECK(NoncentralFisher(f, 2, 2).above(lambda) == Approx(1 - y2 * std::exp(-mu * (1 - y2))).margin(1e-10));
      CHECK(NoncentralFisher(f, 2, 4).above(lambda) ==
            Approx(1 - y4 * std::exp(-mu * (1 - y4)) * (1 + (1 - y4) * (1 + mu * y4))).margin(1e-10));
      CHECK(NoncentralFisher(f, 3, 7).above(0) == Approx(fisherAbove(f, 3, 7)).epsilon(1e-12));
    }
  for (const double df2 : {2., 9., 40.})
    for (const double f : {300., 1000., 3000.})
      CHECK(std::abs(NoncentralFisher(f, 1, df2).above(1000) - NoncentralFisher(f, 1, df2).above(1000.1)) < 0.005);
  CHECK(NoncentralFisher(0, 1, 5).above(3) == 1);
}

TEST_CASE("A quantile is where the distribution has that share") {
  Worst error;
  for (const double share : {1e-6, 0.025, 0.05, 0.3, 0.5, 0.9, 0.975, 0.999}) {
    for (const double df : {1., 2., 9., 19., 37.4, 500.})
      error.see(std::abs(1 - studentAbove(studentQuantile(share, df), df) - share));
  }
  CHECK(error < 1e-14);
}
