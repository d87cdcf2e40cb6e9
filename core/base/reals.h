#pragma once
// Arrays of real numbers in the precision that a scene asks for. Kernels, compiled once for each precision, get the
// bare memory; all other code reads and writes doubles.
#include "base/aligned.h"
#include "base/precision.h"

namespace morula {

/// A pointer to floats or doubles; the kernel that takes it was compiled for one of the two.
struct RealPointer {
  void* place;
  template <class Real>
  operator Real*() const {
    return static_cast<Real*>(place);
  }
};

class Reals {
 public:
  class Reference {
   public:
    operator double() const { return array_.read(at_); }
    Reference& operator=(double a) {
      array_.write(at_, a);
      return *this;
    }
    Reference& operator=(const Reference& other) { return *this = double(other); }
    Reference& operator+=(double a) { return *this = double(*this) + a; }

   private:
    friend class Reals;
    Reference(Reals& array, std::size_t at) : array_(array), at_(at) {}
    Reals& array_;
    std::size_t at_;
  };

  explicit Reals(Precision precision = Precision::binary64) : precision_(precision) {}

  std::size_t size() const { return precision_ == Precision::binary64 ? doubles_.size() : floats_.size(); }
  void assign(std::size_t size, double a) {
    if (precision_ == Precision::binary64) doubles_.assign(size, a);
    else floats_.assign(size, static_cast<float>(a));
  }
  std::size_t bytes() const { return doubles_.size() * sizeof(double) + floats_.size() * sizeof(float); }
  double operator[](std::size_t i) const { return read(i); }
  /// Refers to a number of the array. A value that is written to it is rounded to the array's precision.
  Reference operator[](std::size_t i) { return {*this, i}; }
  /// Returns a pointer to element i.
  RealPointer from(std::size_t i) {
    if (precision_ == Precision::binary64) return {doubles_.data() + i};
    return {floats_.data() + i};
  }

  friend bool operator==(const Reals&, const Reals&) = default;

 private:
  double read(std::size_t i) const { return precision_ == Precision::binary64 ? doubles_[i] : double(floats_[i]); }
  void write(std::size_t i, double a) {
    if (precision_ == Precision::binary64) doubles_[i] = a;
    else floats_[i] = static_cast<float>(a);
  }

  Precision precision_;
  AlignedVector<double> doubles_;  // doubles_ or floats_ is empty
  AlignedVector<float> floats_;
};

}  // namespace morula
