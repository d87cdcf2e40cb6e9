#pragma once
// An optional value on the heap, like std::indirect of C++26. Code that holds or passes on an Indirect needs only a
// declaration of T. Copies and destroys its value with itself, and is const with its owner.
#include <utility>

namespace morula {

template <class T>
class Indirect {
 public:
  Indirect() = default;
  Indirect(T value) : value_(new T(std::move(value))), operations_(&known()) {}
  Indirect(const Indirect& other)
      : value_(other ? other.operations_->copy(*other.value_) : nullptr), operations_(other.operations_) {}
  Indirect(Indirect&& other) noexcept : value_(std::exchange(other.value_, nullptr)), operations_(other.operations_) {}
  Indirect& operator=(Indirect other) noexcept {
    std::swap(value_, other.value_), std::swap(operations_, other.operations_);
    return *this;
  }
  ~Indirect() { reset(); }

  void reset() {
    if (value_) operations_->destroy(std::exchange(value_, nullptr));
  }
  bool has_value() const { return value_; }
  const T* get() const { return value_; }  // or null
  explicit operator bool() const { return value_; }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_; }
  const T* operator->() const { return value_; }

 private:
  struct Operations {
    T* (*copy)(const T&);
    void (*destroy)(T*);
  };
  /// Requires the complete type T, so only code that makes a value calls this.
  static const Operations& known() {
    static constexpr Operations operations{[](const T& value) { return new T(value); }, [](T* value) { delete value; }};
    return operations;
  }

  T* value_ = nullptr;
  const Operations* operations_ = nullptr;
};

}  // namespace morula
