#pragma once
// Texts and bytes as they may stand in HTML. Every text that comes from a scenario or a database goes through one of these.
#include <string>
#include <string_view>

namespace morula {

/// Between tags and in quoted attributes: & < > " ' are named. What is not UTF-8 must have been made visible before.
std::string htmlText(std::string_view text);

/// JSON for a script element: < > & and the line ends of Unicode (U+2028, U+2029) as \u003c …, so that nothing in it ends
/// the element or begins a comment. It reads as the same JSON.
std::string scriptJson(std::string_view json);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// "data:image/png;base64,…"
std::string dataUri(std::string_view type, std::string_view bytes);

/// The 32 bytes of the SHA-256 [FIPS 180-4], by which a page says which programs may run in it.
std::string sha256(std::string_view bytes);

}  // namespace morula
