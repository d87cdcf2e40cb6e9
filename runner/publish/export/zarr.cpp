#include "export/zarr.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "files/bytes.h"

namespace morula {

namespace {

/// Writes JSON in ASCII, since readers take it for that.
std::string asciiText(const Json& json) { return jsonText(json, 2, JsonCharacters::ascii) + "\n"; }

}  // namespace

void ZarrFolder::group(const std::string& path, const Json& attributes) {
  const std::string folder = path.empty() ? "" : path + "/";
  files_.emplace_back(folder + ".zgroup", asciiText({{"zarr_format", 2}}));
  if (!attributes.empty()) files_.emplace_back(folder + ".zattrs", asciiText(attributes));
}

template <class Number>
void ZarrFolder::array(const std::string& path, const std::vector<Number>& values, std::vector<std::size_t> shape) {
  std::string bytes;
  for (const Number value : values)
    if constexpr (sizeof value == 1) put8(bytes, value);
    else put64(bytes, std::bit_cast<std::uint64_t>(value));
  if (shape.empty()) shape = {values.size()};
  const char* type = sizeof(Number) == 1 ? "|b1" : std::is_floating_point_v<Number> ? "<f8" : "<u8";
  addArray(path, type, shape, nullptr, std::move(bytes));
}
template void ZarrFolder::array(const std::string&, const std::vector<double>&, std::vector<std::size_t>);
template void ZarrFolder::array(const std::string&, const std::vector<std::uint64_t>&, std::vector<std::size_t>);
template void ZarrFolder::array(const std::string&, const std::vector<std::uint8_t>&, std::vector<std::size_t>);

void ZarrFolder::array(const std::string& path, const std::vector<std::string>& texts) {
  std::string bytes;
  put32(bytes, static_cast<std::uint32_t>(texts.size()));
  for (const std::string& text : texts) put32(bytes, static_cast<std::uint32_t>(text.size())), bytes += text;
  addArray(path, "|O", {texts.size()}, Json::array({{{"id", "vlen-utf8"}}}), std::move(bytes));
}

void ZarrFolder::addArray(const std::string& path, const char* type, const std::vector<std::size_t>& shape,
                          const Json& filters, std::string bytes) {
  std::vector<std::size_t> chunk = shape;  // a length of 0 is no chunk's
  for (std::size_t& length : chunk) length = std::max<std::size_t>(length, 1);
  const Json about{{"zarr_format", 2}, {"shape", shape},     {"chunks", chunk},       {"dtype", type},
                   {"order", "C"},     {"filters", filters}, {"compressor", nullptr}, {"fill_value", nullptr}};
  files_.emplace_back(path + "/.zarray", asciiText(about));
  if (chunk != shape) return;  // no values, no chunk
  std::string name = "0";
  for (std::size_t axis = 1; axis < shape.size(); ++axis) name += ".0";
  files_.emplace_back(path + "/" + name, std::move(bytes));
}

}  // namespace morula
