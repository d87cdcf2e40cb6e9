#pragma once
// The format of the numbers that physics keeps and computes with.

namespace morula {

enum class Precision {
  binary64,  // double: the default
  binary32,  // float: half the memory, twice as many side by side, seven digits
};

}  // namespace morula
