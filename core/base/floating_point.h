#pragma once
// The processor's rounding mode. Programs and libraries can change it: a library linked with -ffast-math makes every
// program that loads it flush denormal numbers to zero.

namespace morula {

/// Sets this thread to the mode of "Same bits" in core/README.md: rounding to nearest, denormal numbers kept, no
/// exceptions. Every program calls this first of all; parallelFor calls it on its threads.
void setFloatingPoint();

/// An object during whose life this thread has the mode of setFloatingPoint. Its end restores the former mode, for
/// programs of others that call the simulator.
class FloatingPointMode {
 public:
  FloatingPointMode();
  ~FloatingPointMode();
  FloatingPointMode(const FloatingPointMode&) = delete;
  FloatingPointMode& operator=(const FloatingPointMode&) = delete;

 private:
  unsigned long control_ = 0;      // MXCSR or FPCR
  unsigned short x87Control_ = 0;  // of the x87 unit
};

}  // namespace morula
