#include "views/film.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "drawing/drawing.h"
#include "drawing/png_file.h"
#include "files/read_file.h"
#include "files/scratch_folder.h"
#include "files/write_file.h"
#include "pictures/pictures.h"
#include "system/child_process.h"
#include "system/signals.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t maxBytes = std::uint64_t{2} << 30;  // of a film

/// How ffmpeg makes each kind. Films are made of 2 x 2 blocks of pixels, so sides that are odd get a row of paper.
std::vector<std::string> wayTo(const std::string& ending) {
  const std::string even =
      fmt::format("pad=ceil(iw/2)*2:ceil(ih/2)*2:color=0x{:02x}{:02x}{:02x}", paper.r, paper.g, paper.b);
  if (ending == ".mp4")
    return {"-vf", even, "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
  if (ending == ".webm") return {"-vf", even, "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt", "yuv420p"};
  // A palette of its own for the whole film, and no dots: areas of one colour stay so.
  return {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none"};
}

}  // namespace

bool isFilmName(const fs::path& file) {
  const std::string ending = endingOf(file);
  return ending == ".mp4" || ending == ".webm" || ending == ".gif";
}

bool hasFfmpeg() { return !runChild({"ffmpeg", "-hide_banner", "-version"}, {.silent = true}).notStarted(); }

void writeFilm(std::size_t count, const std::function<Image(std::size_t)>& draw, double perSecond,
               const fs::path& file) {
  const SignalWatch watch;  // a signal must not leave the folder behind
  const ScratchFolder folder(file.parent_path());
  for (std::size_t i = 0; i < count; ++i) {
    stopAtSignal();
    writeNewFile(folder.path() / fmt::format("{:06}.png", i), pngFile(draw(i)));
  }
  const fs::path film = folder.path() / ("film" + endingOf(file));
  std::vector<std::string> command{"ffmpeg",     "-nostdin",           "-v", "error",
                                   "-xerror",  // a write that fails is an error
                                   "-framerate", exactText(perSecond), "-i", (folder.path() / "%06d.png").string()};
  for (const std::string& word : wayTo(endingOf(file))) command.push_back(word);
  // No date and no version in the file.
  for (const char* word : {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-threads", "1"})
    command.push_back(word);
  command.push_back(film.string());
  const ChildEnd end = runChild(command, {.errorsToo = true});
  stopAtSignal();
  if (!end.well()) {
    std::string said = end.said.substr(0, 500);
    while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
    std::replace(said.begin(), said.end(), '\n', ';');
    throw FileError(file.string() + ": ffmpeg " + end.text() + (said.empty() ? "" : ": " + said) +
                    "; a name that ends in .png gives the pictures one by one");
  }
  writeFile(file, readFile(film, maxBytes), Content::picture);
}

std::vector<std::string> writeSequence(std::size_t count, const std::function<Image(std::size_t)>& draw,
                                       const fs::path& file) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < count; ++i) {
    fs::path name = file;
    name.replace_filename(file.stem().string() + fmt::format("-{:04}.png", i));
    writeFile(name, pngFile(draw(i)), Content::picture);
    files.push_back(name.string());
  }
  return files;
}

}  // namespace morula
