#include "division/cut.h"

#include <cmath>

#include "base/maths.h"
#include "base/number_text.h"
#include "division/unfold.h"

namespace morula {

CutResult cutBody(const Body& mother, Faces faces, const Vector& normal, double production) {
  CutResult result;
  Body &a = result.daughters.a, &b = result.daughters.b;
  a = b = mother;
  const Point centre = measureCentroid(mother.position);
  std::vector<char> flatInA(mother.position.size()), flatInB(mother.position.size());
  for (std::size_t v = 0; v < mother.position.size(); ++v) {
    const double height = dot(mother.position[v] - centre, normal);
    Body& beyond = height > 0 ? b : a;  // the daughter for which this vertex lies beyond the plane
    beyond.position[v] = mother.position[v] - height * normal;
    (height > 0 ? flatInB : flatInA)[v] = true;
  }
  unfold(a.position, faces, flatInA, -normal);
  unfold(b.position, faces, flatInB, normal);

  const double volumeA = measureVolume(a.position, faces), volumeB = measureVolume(b.position, faces);
  const double volume = volumeA + volumeB;
  if (!(volumeA >= 0.1 * volume && volumeB >= 0.1 * volume)) {
    result.failure = "the plane through its centre of mass would cut its volume into " + numberText(volumeA) +
                     " and " + numberText(volumeB);
    return result;
  }
  const double shareA = volumeA / volume;
  a.mass = mother.mass * shareA;
  b.mass = mother.mass - a.mass;
  a.pressureConstant = mother.pressureConstant * shareA;
  b.pressureConstant = mother.pressureConstant - a.pressureConstant;
  const double rootA = cubeRoot(volumeA), rootB = cubeRoot(volumeB);
  const double surfaceShareA = rootA * rootA / (rootA * rootA + rootB * rootB);
  a.restScale = mother.restScale * std::sqrt(production * surfaceShareA);
  b.restScale = mother.restScale * std::sqrt(production * (1 - surfaceShareA));
  return result;
}

Daughters halveSphere(const Body& mother, double radius, const Vector& normal) {
  Daughters d{mother, mother};
  const double shrinkage = cubeRoot(0.5);
  for (Body* daughter : {&d.a, &d.b}) {
    daughter->restScale *= shrinkage;
    daughter->mass *= 0.5;
    daughter->pressureConstant *= 0.5;
  }
  const Vector aside = (radius * (1 - shrinkage)) * normal;
  d.a.position[0] += aside;
  d.b.position[0] -= aside;
  return d;
}

}  // namespace morula
