#include "cli/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "organism/camera.h"
#include "views/film.h"

namespace morula::cli {
namespace {

/// Reads a finite number; absent for anything else.
std::optional<double> finite(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string> parts(const std::string& text, char between) {
  std::vector<std::string> list{""};
  for (const char c : text)
    if (c == between) list.emplace_back();
    else list.back() += c;
  return list;
}

ClipPlane readClip(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : parts(text, ','))
    if (const auto value = finite(part)) numbers.push_back(*value);
    else numbers.assign(5, 0);
  const bool good = numbers.size() == 4 && (numbers[0] != 0 || numbers[1] != 0 || numbers[2] != 0);
  if (!good)
    throw InputError(
        "'" + text +
        "' is no plane; needs X,Y,Z,OFFSET, such as 0,-1,0,0: the part with X·x + Y·y + Z·z > OFFSET is cut away");
  return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

CellOpacity readOpacity(const std::string& text) {
  const auto sign = text.find('=');
  CellOpacity wish{sign == text.npos ? "*" : text.substr(0, sign), 1};
  const auto value = finite(sign == text.npos ? text : text.substr(sign + 1));
  if (wish.pattern.empty() || !value || !(*value >= 0 && *value <= 1))
    throw InputError("'" + text +
                     "' needs a number from 0 (not drawn) to 1 (solid), for all cells, or SUBSTANCE=NUMBER, "
                     "such as a4=0.3");
  wish.opacity = *value;
  return wish;
}

std::vector<ForceKind> readForces(const std::string& text) {
  const auto all = valuesOf<ForceKind>();
  if (text == "all") return {all.begin(), all.end()};
  return {parseChoice<ForceKind>(text)};
}

constexpr double maxSamples = 50e6;  // as in organism.h

}  // namespace

PictureWishes wishesOf(const RenderOptions& options) {
  PictureWishes wishes = options.wishes;
  FigureSize figure = options.figure.both();
  if (figure.inPrint && options.style == PictureStyle::both) figure.width /= 2;
  figure.set(wishes, dotsAsPixels, 1);
  if (const double samples = 1.0 * wishes.width * wishes.height * wishes.samples * wishes.samples;
      options.style != PictureStyle::lineage && samples > maxSamples)
    throw UsageError(
        fmt::format("--size: {}x{} pixels with --supersample {} take too much memory; width · height · samples² must "
                    "not exceed {:.0f}",
                    wishes.width, wishes.height, wishes.samples, maxSamples));
  for (const auto& kinds : options.forces)
    for (const ForceKind kind : kinds)
      if (std::ranges::find(wishes.forces, kind) == wishes.forces.end()) wishes.forces.push_back(kind);
  return wishes;
}

void checkOutput(const RenderOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  const auto refuse = [&](const std::string& why) {
    throw UsageError("--output: '" + options.output + "' ends in " + ending + why);
  };
  const bool isTree = options.style == PictureStyle::lineage || !options.compared.empty(),
             isFilm = isFilmName(options.output) && !isTree, isOne = !options.moves() && options.beside.empty();
  if (options.perSecond && !isFilm)
    throw UsageError("--fps needs a film; leave it out, or give -o a name that ends in .mp4, .webm or .gif");
  if (!isFilm) try {
      return checkPictureName("render", options.output, isTree || isOne);
    } catch (const InputError& error) { throw UsageError(std::string("--output: ") + error.what()); }
  if (!options.moves())
    refuse(", a film, but there is one picture; needs --turntable N or --frames N, or a name that ends in .png");
  if (!hasFfmpeg())
    refuse(
        ", which needs the program ffmpeg, and PATH does not have it; needs a name that ends in .png (numbered "
        "pictures), or ffmpeg (Debian: apt install ffmpeg)");
}

void add(Verb& verb, RenderOptions& options) {
  PictureWishes& wishes = options.wishes;
  verb.needs("file", options.file, "FILE", "A scenario or a database; with --compare a PNG picture");
  addRunChoice(verb, options.run);
  verb.takes("--time", options.time, "TIME", number(scenario::notNegative), "Time to draw; default: the end");
  verb.takes("--style", options.style, "NAME", parseChoice<PictureStyle>, namesOf<PictureStyle>());
  verb.takes(
      "--view", wishes.camera, "VIEW", parseView,
      "Direction of view: front, back, left, right, top, bottom, iso, or azimuth and elevation in degrees: 30,20; "
      "default: from the front, a little from the right and above");
  addFigure(verb, options.figure, 64, 8192);
  verb.takes("--supersample", wishes.samples, "N", natural(1, 4),
             "Samples along a pixel's side, 1 to 4: smoother edges");
  verb.takes(
      "--colour", wishes.colouring, "WHAT", parseColouring,
      "Colour cells by substance, clone, clone:N (founders N divisions below the egg), generation, or a measure of "
      "cells, such as volume; default: substance");
  verb.takes("--opacity", wishes.opacities, "[SUBSTANCE=]NUMBER,...", readOpacity,
             "Opacity of all cells, or of cells with a substance: 0 to 1");
  verb.takes("--clip", wishes.clip, "X,Y,Z,OFFSET", readClip, "Cut away the part in which X·x + Y·y + Z·z > OFFSET");
  verb.takes("--labels", wishes.labels, "WHAT", parseChoice<Labels>, "Labels of the cells: name or path");
  verb.takes("--forces", options.forces, "KIND,...", readForces,
             "Draw arrows for forces: " + namesOf<ForceKind>() + "; or all");
  verb.takes("--normals", wishes.normals, "Draw the normal of each vertex");
  verb.takes("--connections", wishes.connections, "Draw a line between the centres of connected cells");
  verb.takes("--axes", wishes.axes, "Show the directions of x, y and z");
  verb.takes("--scale-bar", wishes.scaleBar, "Show a scale bar");
  verb.takes("--transparent", wishes.transparent, "Leave the background transparent");
  verb.takes("--turntable", options.turntable, "N", natural(2, 10'000), "N pictures from all around");
  verb.takes("--frames", options.frames, "N", natural(2, 10'000),
             "Draw N pictures, evenly from the start to the end, or to --time");
  verb.oneOf({"--turntable", "--frames"});
  verb.takes("--fps", options.perSecond, "N", number({.low = 0.1, .high = 1000}),
             "Pictures per second of a film; default: 25");
  verb.takes("--beside", options.beside, "FILE",
             "Draw another scenario or database beside it, and the distance of their surfaces");
  verb.excludes("--beside", {"--style both", "--forces", "--turntable", "--frames"},
                "--beside shows one moment of solid cells");
  verb.takes("--compare", options.compared, "FILE",
             "Tell how different the file and this PNG picture look, and draw no organism; -o draws where they differ; "
             "exit code 1: people would see the difference");
  verb.allowsOnly("--compare", {"--output", "--json", "--quiet"}, "--compare compares two pictures and draws no other");
  verb.excludes(
      "--style lineage",
      {"--view", "--supersample", "--colour", "--opacity", "--clip", "--labels", "--forces", "--normals",
       "--connections", "--axes", "--scale-bar", "--transparent", "--turntable", "--frames", "--fps", "--beside"},
      "--style lineage draws a tree, and the other option is for cells in space (morula lineage -o has labels and colours "
      "of trees)");
  verb.takes(
      "-o,--output", options.output, "FILE",
      "File to write: .png (numbered if there are several), .mp4, .webm or .gif; one picture also as .svg or .pdf; "
      "default: the scenario's name");
  add(verb, options.input);
  add(verb, options.execution);
  add(verb, options.messages);
}

}  // namespace morula::cli
