#include "compiler/verify/heights/measure_lakes.h"

#include <algorithm>
#include <array>
#include <map>

#include "compiler/contract/tolerance.h"
#include "compiler/verify/heights/water_levels.h"

namespace citykiln::verify {
namespace {

// The largest deviation of the faces of one water; -1 without a face.
struct Deviation {
  double largest_m = -1;
  Vec2 at{};

  void add(const WaterParts& water, Vec3 corner) {
    const double off_m = off_level_m(water, corner.z);
    if (off_m > largest_m) largest_m = off_m, at = in_plan(corner);
  }
};

// True if a face belongs to a level part: its corners do, drawn in a little from the shore.
bool stands(const WaterParts& water, const GroundFace& face) {
  constexpr double kInwards = 1.0 / 16;
  const Vec2 a = in_plan(face.corners[0]), b = in_plan(face.corners[1]), c = in_plan(face.corners[2]);
  const Vec2 centre = (a + b + c) * (1.0 / 3);
  return std::ranges::all_of(std::array{a, b, c},
                             [&](Vec2 p) { return stands_at(water, p + (centre - p) * kInwards); });
}

}  // namespace

Lakes combined(const Lakes& a, const Lakes& b) {
  const Lakes& worst = b.largest_m > a.largest_m ? b : a;
  return {a.waters + b.waters, a.not_level + b.not_level, worst.largest_m, worst.worst, worst.at};
}

Lakes measure_lakes(const scene::Chunk& chunk, const GroundIndex& ground) {
  const WaterLevels waters = water_levels_of(chunk);
  std::map<OsmId, Deviation> deviations;
  for (const GroundFace& face : ground.faces) {
    const auto water = waters.find(face.feature);
    if (water == waters.end() || !stands(water->second, face)) continue;
    for (const Vec3& corner : face.corners) deviations[face.feature].add(water->second, corner);
  }
  Lakes lakes;
  for (const auto& [id, deviation] : deviations) {
    ++lakes.waters;
    lakes.not_level += deviation.largest_m > kQuantum_m;
    if (deviation.largest_m <= lakes.largest_m) continue;
    lakes.largest_m = deviation.largest_m, lakes.worst = id, lakes.at = deviation.at;
  }
  return lakes;
}

}  // namespace citykiln::verify
