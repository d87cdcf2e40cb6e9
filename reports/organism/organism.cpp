#include "organism/organism.h"

#include <algorithm>
#include <cmath>

#include "base/cell_path.h"
#include "base/error.h"
#include "drawing/annotations.h"
#include "organism/camera.h"
#include "organism/labels.h"
#include "organism/organism_renderer.h"
#include "organism/shell_wall.h"

namespace morula {
namespace {

bool finite(const Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Returns the number of vertices that these faces refer to.
std::int32_t neededBy(const std::vector<Face>& faces) {
  std::int32_t needed = 0;
  for (const Face& face : faces)
    for (const auto corner : face) {
      if (corner < 0) throw InputError("the picture's faces count vertices from 0, not from a negative number");
      needed = std::max(needed, corner + 1);
    }
  return needed;
}

void checkCells(const OrganismPicture& picture) {
  const std::int32_t neededByMost = neededBy(picture.faces);
  for (const CellShape& cell : picture.cells) {
    const std::int32_t needed = cell.faces.empty() ? neededByMost : neededBy(cell.faces);
    if (cell.vertices.size() < std::size_t(needed))
      throw InputError(cellName(cell.path) + " has " + std::to_string(cell.vertices.size()) +
                       " vertices; its faces in the picture need " + std::to_string(needed));
    if (!std::all_of(cell.vertices.begin(), cell.vertices.end(), finite))
      throw InputError(cellName(cell.path) + " has a vertex that is not finite and cannot be drawn");
    if (!cell.shares.empty() && cell.shares.size() != cell.vertices.size())
      throw InputError(cellName(cell.path) + " has " + std::to_string(cell.shares.size()) +
                       " values of a map for its " + std::to_string(cell.vertices.size()) + " vertices");
    if (!std::all_of(cell.shares.begin(), cell.shares.end(), [](double s) { return s >= 0 && s <= 1; }))
      throw InputError("the values of a map on " + cellName(cell.path) + " must be shares of its scale, from 0 to 1");
    if (!(cell.opacity >= 0 && cell.opacity <= 1))
      throw InputError("the opacity of " + cellName(cell.path) + " must be 0 (not drawn) to 1 (solid)");
  }
}

void check(const OrganismPicture& picture) {
  const auto fits = [](int side) { return side >= 16 && side <= 8192; };
  if (!fits(picture.width) || !fits(picture.height))
    throw InputError("a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                     " pixels cannot be drawn; width and height must be 16 to 8192");
  if (picture.samples < 1 || picture.samples > 4)
    throw InputError("a picture cannot have " + std::to_string(picture.samples) +
                     " samples per pixel side; it must be 1 to 4");
  constexpr long long maxSamples = 50'000'000;  // of some 40 bytes each
  if (1LL * picture.width * picture.height * picture.samples * picture.samples > maxSamples)
    throw InputError("a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                     " pixels with " + std::to_string(picture.samples) +
                     " samples per pixel side takes too much memory; width · height · samples² must not exceed " +
                     std::to_string(maxSamples));
  if (picture.shell &&
      !(finite(*picture.shell) && picture.shell->x > 0 && picture.shell->y > 0 && picture.shell->z > 0))
    throw InputError("the shell's semi-axes must be greater than 0");
  for (const LineMark& line : picture.lines)
    if (!finite(line.from) || !finite(line.to)) throw InputError("a line of the picture has an end that is not finite");
  if (picture.clip &&
      !(finite(picture.clip->normal) && std::isfinite(picture.clip->offset) && norm(picture.clip->normal) > 0))
    throw InputError("a clip plane needs a normal other than (0, 0, 0), and a finite offset");
  for (const CellLabel& label : picture.labels)
    if (label.cell >= picture.cells.size())
      throw InputError("the label '" + label.text + "' belongs to no cell of the picture");
  const auto& framing = picture.camera.framing;
  if (framing && !(finite(framing->centre) && framing->distance > 0 && std::isfinite(framing->distance)))
    throw InputError("the camera's framing must be finite, with a distance greater than 0");
  checkCells(picture);
}

Annotations wordsOf(const OrganismPicture& picture) { return {picture.title, picture.caption, picture.legend}; }

std::string hiddenWords(std::size_t labels) {
  return ", " + std::to_string(labels) + " of them without a label (hidden, or no room)";
}

double textSizeOf(const OrganismPicture& picture, int width) {
  return textSizeFor(width, picture.height, picture.print);
}

int instrumentsHeight(const OrganismPicture& picture, int width) {
  return instrumentsHeight(picture.instruments, width, textSizeOf(picture, width));
}

Bands bandsOf(const OrganismPicture& picture, int width) {
  Annotations words = wordsOf(picture);
  if (!picture.labels.empty()) words.caption += hiddenWords(picture.labels.size());  // the most that it can become
  return bandsFor(words, width, picture.height, picture.print.textSize);
}

int sceneHeight(const OrganismPicture& picture, int width) {
  const Bands bands = bandsOf(picture, width);
  const int height = picture.height - bands.top - bands.bottom - instrumentsHeight(picture, width);
  if (height < 16)
    throw InputError("words and scales leave no room for the cells in a picture of " + std::to_string(width) + " x " +
                     std::to_string(picture.height) + " pixels; it must be larger, or show fewer of them");
  return height;
}

/// Returns the points that must lie inside the picture.
std::vector<Point> extent(const OrganismPicture& picture) {
  std::vector<Point> points;
  if (picture.shell) {
    const Vector semi = *picture.shell * shellThickness;
    for (const Point& p : makeIcosphere(3).vertices) points.push_back({p.x * semi.x, p.y * semi.y, p.z * semi.z});
  }
  // A shell alone defines the framing, so that births and deaths of cells do not change it.
  for (const CellShape& cell : picture.cells)
    if (cell.opacity > 0 && !picture.shell) points.insert(points.end(), cell.vertices.begin(), cell.vertices.end());
  for (const LineMark& line : picture.lines) points.push_back(line.from), points.push_back(line.to);
  return points;
}

Framing framingOf(const std::vector<Point>& points, const OrganismPicture& picture, int width) {
  return frame(points, eyeAxes(picture.camera), apertureOf(picture.width, sceneHeight(picture, width)));
}

/// `pictureOf(i)` returns picture number i, counted from 0.
template <class PictureOf>
Framing framingOfAll(std::size_t count, const PictureOf& pictureOf) {
  if (count == 0) throw InputError("a framing needs at least one picture");
  std::optional<FramingFinder> finder;
  for (std::size_t i = 0; i < count; ++i) {
    const OrganismPicture& one = pictureOf(i);
    check(one);
    if (!finder) finder.emplace(eyeAxes(one.camera), apertureOf(one.width, sceneHeight(one, one.width)));
    for (const Point& p : extent(one)) finder->seeFirst(p);
  }
  for (std::size_t i = 0; i < count; ++i)
    for (const Point& p : extent(pictureOf(i))) finder->seeAgain(p);
  return finder->framing();
}

/// Returns the labels of all visible cells. A translucent cell owns no pixels, so its label is placed at its middle.
std::vector<LabelWish> labelsOf(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing,
                                const Aperture& aperture, const LabelGround& ground) {
  std::vector<LabelWish> wishes;
  for (const CellLabel& label : picture.labels) {
    const CellShape& cell = picture.cells[label.cell];
    LabelWish wish{std::uint32_t(label.cell + 1), label.text, std::nullopt};
    if (cell.opacity == 0 || cell.vertices.empty()) continue;
    if (cell.opacity < 1) {
      const Point middle = middleOf(cell);
      if (picture.clip && dot(middle, picture.clip->normal) > picture.clip->offset) continue;
      const Vector p = axes.of(middle - framing.centre);
      const double depth = framing.distance - p.z;
      if (!(depth > 0)) continue;
      wish.at = Spot{0.5 * ground.width * (1 + p.x / (aperture.x * depth)),
                     0.5 * ground.height * (1 - p.y / (aperture.y * depth))};
    }
    wishes.push_back(std::move(wish));
  }
  return wishes;
}

OrganismRenderer& rendererOfThisThread() {
  static thread_local OrganismRenderer renderer;
  return renderer;
}

}  // namespace

Drawing organismDrawing(const OrganismPicture& picture, const std::vector<Style>& styles) {
  check(picture);
  const int width = picture.width * int(styles.size()), height = sceneHeight(picture, width);
  const Framing framing = picture.camera.framing ? *picture.camera.framing : framingOf(extent(picture), picture, width);
  Drawing drawing(width, picture.height, picture.transparent ? Drawing::Ground::none : Drawing::Ground::paper,
                  picture.print);
  const int top = bandsOf(picture, width).top;
  const EyeAxes axes = eyeAxes(picture.camera);
  const Aperture aperture = apertureOf(picture.width, height);
  Annotations words = wordsOf(picture);
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const int left = picture.width * int(i);
    drawing.image(left, top, rendererOfThisThread().draw(picture, styles[i], framing, picture.width, height));
    if (picture.labels.empty()) continue;
    const LabelGround ground{picture.width, height, rendererOfThisThread().owners()};
    const double size = smallText * textSizeOf(picture, width);
    const auto placed = placeLabels(ground, labelsOf(picture, axes, framing, aperture, ground), size);
    drawLabels(drawing, placed, left, top, size);
    const std::size_t hidden = picture.labels.size() - placed.size();
    if (i == 0 && hidden > 0 && !words.caption.empty()) words.caption += hiddenWords(hidden);
  }
  const double pixelsPerLength = 0.5 * picture.width / (aperture.x * framing.distance);
  drawInstruments(drawing, picture.instruments, {axes.x, axes.y, axes.z, pixelsPerLength}, top + height,
                  textSizeOf(picture, width));
  annotate(drawing, words, picture.print.textSize);
  return drawing;
}

Image drawOrganism(const OrganismPicture& picture, Style style) { return organismDrawing(picture, {style}).pixels(); }

Framing fitFraming(const OrganismPicture& picture) { return fitFraming(std::vector<OrganismPicture>{picture}); }

Framing fitFraming(const std::vector<OrganismPicture>& sequence) {
  return framingOfAll(sequence.size(), [&](std::size_t i) -> const OrganismPicture& { return sequence[i]; });
}

Framing fitFraming(std::size_t count, const std::function<OrganismPicture(std::size_t)>& picture) {
  return framingOfAll(count, picture);
}

Framing commonFraming(const OrganismPicture& picture, const std::vector<Camera>& cameras) {
  if (cameras.empty()) throw InputError("a framing needs at least one side to look from");
  check(picture);
  const std::vector<Point> points = extent(picture);
  if (points.empty()) return {};
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Aperture aperture = apertureOf(picture.width, sceneHeight(picture, picture.width));
  Framing framing{(low + high) * 0.5, 0};
  for (const Camera& camera : cameras)
    framing.distance = std::max(framing.distance, distanceFor(points, framing.centre, eyeAxes(camera), aperture));
  return framing;
}

Point middleOf(const CellShape& cell) {
  Point middle;
  for (const Point& p : cell.vertices) middle += p / double(cell.vertices.size());
  return middle;
}

double meanRadius(const OrganismPicture& picture, std::size_t cells) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const Point middle = middleOf(picture.cells[i]);
    for (const Point& p : picture.cells[i].vertices) sum += norm(p - middle), ++count;
  }
  return count ? sum / double(count) : 1;
}

void addNormals(OrganismPicture& picture, double length, Colour colour) {
  checkCells(picture);
  for (const CellShape& cell : picture.cells) {
    const std::vector<Vector> normals = vertexNormals(cell.vertices, facesOf(picture, cell));
    for (std::size_t i = 0; i < normals.size(); ++i)
      picture.lines.push_back({cell.vertices[i], cell.vertices[i] + normals[i] * length, colour});
  }
}

}  // namespace morula
