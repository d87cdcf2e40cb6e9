#include "division/cut.h"

#include <cmath>

#include "base/maths.h"
#include "base/number_text.h"
#include "division/unfold.h"

namespace morula {

CutResult cutBody(const Body& mother, Faces faces, const Cut& cut, double areaFactor) {
  CutResult result;
  Body &a = result.daughters.a, &b = result.daughters.b;
  a = b = mother;
  const Vector& normal = cut.normal;
  std::vector<char> flatInA(mother.position.size()), flatInB(mother.position.size());
  for (std::size_t v = 0; v < mother.position.size(); ++v) {
    const double height = dot(mother.position[v] - cut.point, normal);
    Body& beyond = height > 0 ? b : a;  // the daughter for which this vertex lies beyond the plane
    beyond.position[v] = mother.position[v] - height * normal;
    (height > 0 ? flatInB : flatInA)[v] = true;
  }
  unfold(a.position, faces, flatInA, -normal);
  unfold(b.position, faces, flatInB, normal);

  const double volumeA = measureVolume(a.position, faces), volumeB = measureVolume(b.position, faces);
  const double volume = volumeA + volumeB;
  if (!(volumeA >= 0.1 * volume && volumeB >= 0.1 * volume)) {
    result.failure =
        "its plane would cut its volume into " + numberText(volumeA) + " and " + numberText(volumeB);
    return result;
  }
  const double shareA = volumeA / volume;
  a.mass = mother.mass * shareA;
  b.mass = mother.mass - a.mass;
  a.pressureConstant = mother.pressureConstant * shareA;
  b.pressureConstant = mother.pressureConstant - a.pressureConstant;
  const double rootA = cubeRoot(volumeA), rootB = cubeRoot(volumeB);
  const double surfaceShareA = rootA * rootA / (rootA * rootA + rootB * rootB);
  a.restScale = mother.restScale * std::sqrt(areaFactor * surfaceShareA);
  b.restScale = mother.restScale * std::sqrt(areaFactor * (1 - surfaceShareA));
  return result;
}

Daughters divideSphere(const Body& mother, double radius, const Cut& cut) {
  Daughters d{mother, mother};
  d.a.mass = mother.mass * cut.ratio;
  d.b.mass = mother.mass - d.a.mass;
  d.a.pressureConstant = mother.pressureConstant * cut.ratio;
  d.b.pressureConstant = mother.pressureConstant - d.a.pressureConstant;
  const double scaleA = cubeRoot(cut.ratio), scaleB = cubeRoot(1 - cut.ratio);
  d.a.restScale *= scaleA;
  d.b.restScale *= scaleB;
  d.a.position[0] += (radius * (1 - scaleA)) * cut.normal;
  d.b.position[0] -= (radius * (1 - scaleB)) * cut.normal;
  return d;
}

}  // namespace morula
