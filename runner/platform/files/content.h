#pragma once
// The kind of a file's content, by its first bytes and not by its name.
#include <filesystem>
#include <string_view>

namespace morula {

enum class Content { empty, picture, database, golden, scenario, dna, report, page, scene, other };

/// From the first bytes of a file; 4096 are enough.
Content contentOf(std::string_view head);
Content contentOfFile(const std::filesystem::path& file);
/// Names a kind of content in messages: "a picture", "a scenario", …
const char* name(Content content);

/// How pictures begin: any PNG, but only an SVG that says it is Morula's, and a PDF made by cairo, as ours
/// are. Drawings and documents of others are files of another kind.
inline constexpr std::string_view pngBeginning = "\x89PNG\r\n\x1a\n";
inline constexpr std::string_view svgBeginning = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Morula -->\n<svg";
inline constexpr std::string_view pdfBeginning = "%PDF-1.5\n%\xb5\xed\xae\xfb\n";

/// How films begin, from the byte at which each beginning stands: any MP4, WebM and GIF.
inline constexpr std::string_view mp4Beginning = "ftyp";  // at 4
inline constexpr std::string_view webmBeginning = "\x1a\x45\xdf\xa3";
inline constexpr std::string_view gifBeginning = "GIF89a";

/// How the files begin that `morula check --reports` writes. The same texts in writer and reader.
inline constexpr std::string_view junitBeginning =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"morula check\"";
inline constexpr std::string_view summaryBeginning = "### morula check\n";
inline constexpr std::string_view jsonBeginning = "{\n  \"morula\": 1";

/// How scenes begin that `morula validate --scene` writes [core/library/scene_format.h].
inline constexpr std::string_view sceneBeginning = "morula-scene ";

/// How pages begin that `morula report` writes.
inline constexpr std::string_view pageBeginning = "<!DOCTYPE html>\n<!-- Morula report -->\n";

}  // namespace morula
