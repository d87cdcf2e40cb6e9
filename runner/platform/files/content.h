#pragma once
// The kind of a file's content, by its first bytes and not by its name.
#include <filesystem>
#include <string_view>

namespace morula {

enum class Content { empty, picture, database, golden, scenario, dna, report, page, scene, other };

/// Returns the kind of content by the first bytes of a file; 4096 are enough.
Content contentOf(std::string_view head);
Content contentOfFile(const std::filesystem::path& file);
/// Names a kind of content in messages: "a picture", "a scenario", …
const char* name(Content content);

/// The beginnings of pictures: any PNG, but only an SVG of Morula's and a PDF made by cairo, as Morula's are. Drawings
/// and documents of other programs are files of another kind.
inline constexpr std::string_view pngBeginning = "\x89PNG\r\n\x1a\n";
inline constexpr std::string_view svgBeginning = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Morula -->\n<svg";
inline constexpr std::string_view pdfBeginning = "%PDF-1.5\n%\xb5\xed\xae\xfb\n";

/// The beginnings of films: any MP4 (from byte 4), WebM and GIF.
inline constexpr std::string_view mp4Beginning = "ftyp";  // at 4
inline constexpr std::string_view webmBeginning = "\x1a\x45\xdf\xa3";
inline constexpr std::string_view gifBeginning = "GIF89a";

/// The beginnings of files from `morula check --reports`, shared by writer and reader.
inline constexpr std::string_view junitBeginning =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"morula check\"";
inline constexpr std::string_view summaryBeginning = "### morula check\n";
inline constexpr std::string_view jsonBeginning = "{\n  \"morula\": 1";

/// The beginning of scenes from `morula validate --scene` [core/library/scene_format.h].
inline constexpr std::string_view sceneBeginning = "morula-scene ";

/// The beginning of pages from `morula report`.
inline constexpr std::string_view pageBeginning = "<!DOCTYPE html>\n<!-- Morula report -->\n";

}  // namespace morula
