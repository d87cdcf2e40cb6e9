#include "division/coarsen.h"

#include <cmath>

#include "mesh/nesting.h"

namespace morula {
namespace {

constexpr double tolerance = 0.01;

/// False for a NaN.
bool isNear(double actual, double expected) { return std::abs(actual - expected) <= tolerance * std::abs(expected); }

Faces facesOf(const Bodies& b, const Body& body) { return b.meshAt(body.meshLevel).mesh.faces; }

/// Returns the body on the next coarser mesh; its volume is off if no scale can restore it.
Body restrictBody(const Bodies& b, const Body& body) {
  const std::vector<std::int32_t>& nested = b.coarser[body.meshLevel].nested;
  Body coarse = body;
  ++coarse.meshLevel;
  coarse.position = restrictShape(body.position, facesOf(b, body), nested, facesOf(b, coarse));
  coarse.velocity.clear();
  for (std::int32_t v : nested) coarse.velocity.push_back(body.velocity[v]);
  const Vector missing = measureCentroid(body.velocity) - measureCentroid(coarse.velocity);
  for (Vector& u : coarse.velocity) u += missing;
  return coarse;
}

}  // namespace

Body coarsen(const Bodies& b, Body body) {
  while (body.meshLevel < static_cast<int>(b.coarser.size())) {
    if (body.restScale * b.coarser[body.meshLevel].mesh.meanRestLength > *b.parameters.coarsen) break;
    Body coarse = restrictBody(b, body);
    const Faces faces = facesOf(b, body), fewer = facesOf(b, coarse);
    if (!isNear(measureVolume(coarse.position, fewer), measureVolume(body.position, faces)) ||
        !isNear(measureArea(coarse.position, fewer), measureArea(body.position, faces)))
      break;
    body = std::move(coarse);
  }
  return body;
}

}  // namespace morula
