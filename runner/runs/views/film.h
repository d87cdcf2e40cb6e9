#pragma once
// Pictures that move: one file through ffmpeg where that program is installed, or numbered PNG files.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "image/image.h"

namespace morula {

/// True for the endings of films, in capitals or not: .mp4, .webm, .gif.
bool isFilmName(const std::filesystem::path& file);

/// Returns true if ffmpeg can be started.
bool hasFfmpeg();

/// Draws `count` pictures one after the other and writes them as the film that the file's ending asks for, with
/// `perSecond` of them in a second. Equal pictures give equal bytes on one ffmpeg. Replaces a picture or a film, but no
/// file of another kind. Throws FileError with what ffmpeg says if it fails; no half-written file stays.
void writeFilm(std::size_t count, const std::function<Image(std::size_t)>& draw, double perSecond,
               const std::filesystem::path& file);

/// Writes the pictures as "name-0000.png", "name-0001.png", … for "name.png". Returns the files.
std::vector<std::string> writeSequence(std::size_t count, const std::function<Image(std::size_t)>& draw,
                                       const std::filesystem::path& file);

}  // namespace morula
