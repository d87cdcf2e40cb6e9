#include "cli/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "options/exit_codes.h"
#include "options/picture_name.h"
#include "options/verb.h"
#include "organism/views.h"
#include "pictures/film.h"

namespace morula::cli {

namespace {

/// A finite number, or nothing.
std::optional<double> number(std::string_view text) {
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

ClipPlane clipOption(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : parts(text, ','))
    if (const auto value = number(part)) numbers.push_back(*value);
    else numbers.assign(5, 0);
  const bool good = numbers.size() == 4 && (numbers[0] != 0 || numbers[1] != 0 || numbers[2] != 0);
  if (!good)
    throw UsageError(
        "--clip: '" + text +
        "' is no plane; needs X,Y,Z,OFFSET, such as 0,-1,0,0: what has X·x + Y·y + Z·z > OFFSET is cut away");
  return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

CellOpacity opacityOption(const std::string& text) {
  const auto sign = text.find('=');
  CellOpacity wish{sign == text.npos ? "*" : text.substr(0, sign), 1};
  const auto value = number(sign == text.npos ? text : text.substr(sign + 1));
  if (wish.pattern.empty() || !value || !(*value >= 0 && *value <= 1))
    throw UsageError("--opacity: '" + text +
                     "' needs a number from 0 (not drawn) to 1 (solid), for all cells, or SUBSTANCE=NUMBER, "
                     "such as a4=0.3");
  wish.opacity = *value;
  return wish;
}

ForceKind forceOption(const std::string& text) {
  std::vector<std::string> known;
  for (const auto& row : choices<ForceKind>) {
    known.push_back(row.name);
    if (text == row.name) return row.value;
  }
  const std::string near = closest(text, known);
  throw UsageError("--forces: '" + text + "' is not known; needs " + namesOf<ForceKind>() + ", or all" +
                   (near.empty() ? "" : "; did you mean " + near + "?"));
}

Labels labelsOption(const std::string& text) {
  if (text.empty()) return Labels::none;
  if (text == "name") return Labels::name;
  if (text == "path") return Labels::path;
  throw UsageError("--labels: '" + text + "' is not known; needs name or path");
}

/// What an InputError of a room below says of an option's value.
template <class Act>
auto named(const std::string& option, Act act) {
  try {
    return act();
  } catch (const InputError& error) { throw UsageError(option + ": " + error.what()); }
}

constexpr double mostSamples = 50e6;  // as in organism.h

}  // namespace

void checkTreeOptions(const RenderOptions& o) {
  const std::pair<const char*, bool> ofBodies[] = {
      {"--view", !o.view.empty()},           {"--supersample", o.supersample != "2"},
      {"--colour", o.colour != "substance"}, {"--opacity", !o.opacity.empty()},
      {"--clip", !o.clip.empty()},           {"--labels", !o.labels.empty()},
      {"--forces", !o.forces.empty()},       {"--normals", o.normals},
      {"--connections", o.connections},      {"--axes", o.axes},
      {"--scale-bar", o.scaleBar},           {"--transparent", o.transparent},
      {"--turntable", !o.turntable.empty()}, {"--frames", !o.frames.empty()},
      {"--fps", !o.perSecond.empty()},       {"--beside", !o.beside.empty()},
  };
  for (const auto& [name, given] : ofBodies)
    if (given)
      throw UsageError(std::string(name) +
                       " is of cells in space, and --style lineage is a tree; leave out one of them"
                       " (morula lineage -o has labels and colours of trees)");
}

PictureSize sizeOption(const RenderOptions& options) {
  const auto sides = parts(options.size, 'x');
  if (sides.size() > 2)
    throw UsageError("--size: '" + options.size +
                     "' is no size; needs N for a square or WIDTHxHEIGHT in pixels");
  const auto side = [&](const std::string& text) {
    return static_cast<int>(naturalOption("--size", text, 64, 8192));
  };
  return {side(sides.front()), side(sides.back())};
}

PictureWishes wishesOf(const RenderOptions& options) {
  PictureWishes wishes;
  const PictureSize size = sizeOption(options);
  wishes.width = size.width, wishes.height = size.height;
  wishes.samples = static_cast<int>(naturalOption("--supersample", options.supersample, 1, 4));
  if (const double samples = 1.0 * size.width * size.height * wishes.samples * wishes.samples;
      options.style != "lineage" && samples > mostSamples)
    throw UsageError(fmt::format(
        "--size: {}x{} pixels with --supersample {} take too much memory; width · height · samples² must "
        "not exceed {:.0f}",
        size.width, size.height, wishes.samples, mostSamples));
  if (!options.view.empty()) wishes.camera = named("--view", [&] { return parseView(options.view); });
  wishes.colouring = named("--colour", [&] { return parseColouring(options.colour); });
  if (!options.clip.empty()) wishes.clip = clipOption(options.clip);
  wishes.labels = labelsOption(options.labels);
  for (const std::string& words : options.opacity)
    for (const std::string& text : parts(words, ',')) wishes.opacities.push_back(opacityOption(text));
  const auto kinds = valuesOf<ForceKind>();
  for (const std::string& words : options.forces)
    for (const std::string& text : parts(words, ',')) {
      if (text == "all") wishes.forces = {kinds.begin(), kinds.end()};
      else if (const ForceKind kind = forceOption(text);
               std::find(wishes.forces.begin(), wishes.forces.end(), kind) == wishes.forces.end())
        wishes.forces.push_back(kind);
    }
  wishes.transparent = options.transparent;
  wishes.normals = options.normals, wishes.connections = options.connections;
  wishes.axes = options.axes, wishes.scaleBar = options.scaleBar;
  return wishes;
}

Motion motionOf(const RenderOptions& options) {
  Motion motion;
  if (!options.turntable.empty())
    motion.turntable = static_cast<int>(naturalOption("--turntable", options.turntable, 2, 10'000));
  if (!options.frames.empty())
    motion.frames = static_cast<int>(naturalOption("--frames", options.frames, 2, 10'000));
  if (motion.turntable && motion.frames)
    throw UsageError(
        "--turntable goes around one time, and --frames goes through times; leave out one of them");
  if (options.perSecond.empty()) return motion;
  if (!isFilmName(options.output))
    throw UsageError("--fps is of a film; leave it out, or give -o a name that ends in .mp4, .webm or .gif");
  motion.perSecond = positiveOption("--fps", options.perSecond);
  if (!(motion.perSecond >= 0.1 && motion.perSecond <= 1000))
    throw UsageError("--fps: " + options.perSecond + " is out of range; needs a number from 0.1 to 1000");
  return motion;
}

void checkOutput(const RenderOptions& options, const Motion& motion) {
  if (!isFilmName(options.output) || options.style == "lineage")
    return checkPictureName("render", options.output, options.style == "lineage");
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (!motion.any())
    throw UsageError("--output: '" + options.output + "' ends in " + ending +
                     ", a film, and one picture does not move; needs --turntable N or --frames N, or a name "
                     "that ends in .png");
  if (!hasFfmpeg())
    throw UsageError("--output: '" + options.output + "' ends in " + ending +
                     ", which takes the program ffmpeg, and there is none in PATH; needs a name that ends in "
                     ".png (numbered "
                     "pictures), or ffmpeg (Debian: apt install ffmpeg)");
}

void add(Verb& verb, RenderOptions& options) {
  verb.needs("file", options.file, "FILE", "A scenario or a database");
  verb.takes("--run", options.run, "ID", "Which run of the database; default: the latest");
  verb.takes("--time", options.time, "TIME", "When; default: at the end");
  verb.takes("--style", options.style, "NAME", "solid, wireframe, both or lineage");
  verb.takes("--view", options.view, "VIEW",
             "front, back, left, right, top, bottom, iso, or azimuth and elevation in degrees: 30,20; "
             "default: from the "
             "front, a little from the right and above");
  verb.takes("--size", options.size, "N|WxH", "Width and height in pixels: 900 or 1920x1080");
  verb.takes("--supersample", options.supersample, "N",
             "Samples along a pixel's side, 1 to 4: smoother edges");
  verb.takes("--colour", options.colour, "WHAT",
             "substance, clone, clone:N (founders N divisions below the egg), generation, or a measure of "
             "cells, such as volume");
  verb.takes("--opacity", options.opacity, "[SUBSTANCE=]NUMBER",
             "0 to 1: see through all cells, or through some");
  verb.takes("--clip", options.clip, "X,Y,Z,OFFSET", "Cut away what has X·x + Y·y + Z·z > OFFSET");
  verb.takes("--labels", options.labels, "WHAT", "name or path: written at the cells");
  verb.takes("--forces", options.forces, "KIND[,KIND]", "Arrows: " + namesOf<ForceKind>() + "; all");
  verb.takes("--normals", options.normals, "A line out of each vertex");
  verb.takes("--connections", options.connections, "A line between the middles of connected cells");
  verb.takes("--axes", options.axes, "Show which way x, y and z point");
  verb.takes("--scale-bar", options.scaleBar, "Show a length");
  verb.takes("--transparent", options.transparent, "No paper behind the cells");
  verb.takes("--turntable", options.turntable, "N", "N pictures from all around");
  verb.takes("--frames", options.frames, "N", "N pictures, evenly from the start to the end, or to --time");
  verb.takes("--fps", options.perSecond, "N", "Of a film: pictures in a second; default: 25");
  verb.takes("--beside", options.beside, "FILE",
             "Another scenario or database: both side by side, and how far their surfaces are apart");
  verb.takes("-o,--output", options.output, "FILE",
             "The .png, of several pictures numbered, or .mp4, .webm, .gif; of a lineage also .svg or .pdf; "
             "default: the "
             "scenario's name");
  add(verb, options.input);
  add(verb, options.execution);
  add(verb, options.messages);
}

}  // namespace morula::cli
