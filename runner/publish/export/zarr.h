#pragma once
// Groups and arrays of Zarr's format 2: a folder of JSON and of arrays as bytes, for Python, Java and JavaScript.
// An array is one chunk, not compressed [https://zarr-specs.readthedocs.io/en/latest/v2/v2.0.html].
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "system/json.h"

namespace morula {

class ZarrFolder {
 public:
  /// Adds a group, "" the root. Groups above it must be added, too.
  void group(const std::string& path, const Json& attributes = {});
  /// Adds an array of doubles, or of 64-bit or 8-bit numbers without a sign, the latter true or false. The last axis is
  /// filled first, the only one without `shape`.
  template <class Number>
  void array(const std::string& path, const std::vector<Number>& values, std::vector<std::size_t> shape = {});
  /// Adds an array of texts with one axis, in UTF-8 of any length (the filter vlen-utf8).
  void array(const std::string& path, const std::vector<std::string>& texts);

  /// Returns the files' paths from the folder and their bytes.
  const std::vector<std::pair<std::string, std::string>>& files() const { return files_; }

 private:
  void addArray(const std::string& path, const char* type, const std::vector<std::size_t>& shape, const Json& filters,
                std::string bytes);
  std::vector<std::pair<std::string, std::string>> files_;
};

}  // namespace morula
