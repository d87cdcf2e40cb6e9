#include "division/cut.h"

#include <cmath>

#include "base/maths.h"
#include "base/number_text.h"
#include "division/halves.h"

namespace morula {

CutResult cutBody(const Body& mother, Faces faces, const Cut& cut, double areaFactor) {
  // A plane that was placed for a share may miss it a little. A plane through the middle that gives one daughter less
  // than this has cut a shape that was never one piece.
  const double least = cut.share ? 0.05 : 0.1;
  CutResult result;
  Body &a = result.daughters.a, &b = result.daughters.b;
  a = b = mother;
  Halves halves = halve(mother.position, faces, cut.point, cut.normal);
  a.position = std::move(halves.a), b.position = std::move(halves.b);

  const double volumeA = halves.volumeA, volumeB = halves.volumeB;
  const double volume = volumeA + volumeB;
  if (!(volumeA >= least * volume && volumeB >= least * volume)) {
    result.failure =
        "the plane would cut the cell's volume into " + numberText(volumeA) + " and " + numberText(volumeB);
    return result;
  }
  const double shareA = cut.share.value_or(volumeA / volume);
  a.mass = mother.mass * shareA;
  b.mass = mother.mass - a.mass;
  a.pressureConstant = mother.pressureConstant * shareA;
  b.pressureConstant = mother.pressureConstant - a.pressureConstant;
  const double rootA = cubeRoot(cut.share ? shareA : volumeA), rootB = cubeRoot(cut.share ? 1 - shareA : volumeB);
  const double surfaceShareA = rootA * rootA / (rootA * rootA + rootB * rootB);
  a.restScale = mother.restScale * std::sqrt(areaFactor * surfaceShareA);
  b.restScale = mother.restScale * std::sqrt(areaFactor * (1 - surfaceShareA));
  return result;
}

Daughters divideSphere(const Body& mother, double radius, const Cut& cut) {
  Daughters d{mother, mother};
  const double share = cut.share.value_or(0.5);
  d.a.mass = mother.mass * share;
  d.b.mass = mother.mass - d.a.mass;
  d.a.pressureConstant = mother.pressureConstant * share;
  d.b.pressureConstant = mother.pressureConstant - d.a.pressureConstant;
  const double scaleA = cubeRoot(share), scaleB = cubeRoot(1 - share);
  d.a.restScale *= scaleA;
  d.b.restScale *= scaleB;
  d.a.position[0] += (radius * (1 - scaleA)) * cut.normal;
  d.b.position[0] -= (radius * (1 - scaleB)) * cut.normal;
  return d;
}

}  // namespace morula
