// Terrain meshes of heights with spikes: triangles halved while the middle of an edge is off, and refine().
#include <algorithm>
#include <array>
#include <vector>

#include "compiler/ground/mesh/refine.h"
#include "tests/charts/hard_cases.h"

namespace citykiln::charts {
namespace {

constexpr int kSide = 17;
constexpr double kSampleStep_m = 8, kMostOff_m = 0.5;

// Level land, with spikes and ridges one sample wide inside of the border.
map::Heightfield hard_heights(HardDraw& draw) {
  map::Heightfield field{
      .min = {0, 0}, .step_m = {kSampleStep_m, kSampleStep_m}, .columns = kSide, .rows = kSide, .heights = {}};
  field.heights.assign(kSide * kSide, 0);
  const auto height = [&](int i, int j) -> std::int32_t& { return field.heights[j * kSide + i]; };
  const int spikes = draw.whole(1, 6);
  for (int s = 0; s < spikes; ++s) height(draw.whole(1, kSide - 2), draw.whole(1, kSide - 2)) = draw.whole(64, 64 * 40);
  if (draw.whole(0, 1) == 0)
    for (int i = 1, j = draw.whole(1, kSide - 2); i < kSide - 1; ++i) height(i, j) = draw.whole(64, 640);
  return field;
}

using HalvedTriangle = std::array<Vec2, 3>;

// Halves the longest edge while its middle is off, as right-triangulated networks do without errors of descendants.
void halve(const map::Heightfield& field, const HalvedTriangle& t, std::vector<std::array<Vec3, 3>>& mesh) {
  const auto at = [&](Vec2 p) { return Vec3{p.x, p.y, map::height_m_at(field, p)}; };
  const Vec2 middle = (t[1] + t[2]) * 0.5;
  const double off = std::abs(map::height_m_at(field, middle) - (at(t[1]).z + at(t[2]).z) / 2);
  if (off <= kMostOff_m || distance(t[1], t[2]) <= kSampleStep_m) return mesh.push_back({at(t[0]), at(t[1]), at(t[2])});
  halve(field, {middle, t[0], t[1]}, mesh), halve(field, {middle, t[2], t[0]}, mesh);
}

double area2(const std::array<Vec3, 3>& t) { return twice_area({t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y}); }

// The largest vertical distance of the samples in a triangle from it; infinite for a triangle without area.
double worst_of(const map::Heightfield& field, const std::array<Vec3, 3>& t) {
  const double whole = area2(t);
  if (!(whole > 0)) return HUGE_VAL;
  double worst = 0;
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
  for (int j = static_cast<int>(low / kSampleStep_m); j * kSampleStep_m <= high; ++j)
    for (int i = static_cast<int>(left / kSampleStep_m); i * kSampleStep_m <= right; ++i) {
      const Vec2 p = field.vertex(i, j);
      std::array<double, 3> share{};
      for (int k = 0; k < 3; ++k) {
        const Vec3 a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        share[k] = twice_area(p, {a.x, a.y}, {b.x, b.y}) / whole;
      }
      if (share[0] < 0 || share[1] < 0 || share[2] < 0) continue;
      const double z = share[0] * t[0].z + share[1] * t[1].z + share[2] * t[2].z;
      worst = std::max(worst, std::abs(z - field.height_m_at_vertex(i, j)));
    }
  return worst;
}

bool is_within(const map::Heightfield& field, const std::vector<std::array<Vec3, 3>>& mesh) {
  double area = 0;
  for (const std::array<Vec3, 3>& t : mesh) {
    if (worst_of(field, t) > kMostOff_m + 0x1p-10) return false;
    area += area2(t) / 2;
  }
  const double side = (kSide - 1) * kSampleStep_m;
  return std::abs(area - side * side) < 1e-6;
}

std::vector<std::array<Vec3, 3>> refined_mesh(const map::Heightfield& field) {
  const Box2 cell = field.box();
  const ground::Reference reference = ground::reference_of(field, cell);
  ground::Partition partition = ground::partition_all_rings({}, {}, {}, cell);
  std::vector<ground::FaceHeight> heights(partition.triangulation.faces().size());
  const ground::Refined refined = ground::refine(std::move(partition), std::move(heights), reference, kMostOff_m);
  std::vector<std::array<Vec3, 3>> mesh;
  const auto at = [&](std::uint32_t v) {
    const Vec2 p = plane_point(refined.triangulation.vertices()[v]);
    return Vec3{p.x, p.y, refined.heights[v][0]};
  };
  for (const DelaunayFace& face : refined.triangulation.faces())
    mesh.push_back({at(face.vertices[0]), at(face.vertices[1]), at(face.vertices[2])});
  return mesh;
}

}  // namespace

Judged judge_refinement(HardDraw& draw) {
  const map::Heightfield field = hard_heights(draw);
  std::vector<std::array<Vec3, 3>> halved;
  // squares of four samples, as a program that expects no spikes may begin
  constexpr double kSquare_m = 4 * kSampleStep_m;
  for (int square = 0; square < 16; ++square) {
    const Vec2 a{square % 4 * kSquare_m, square / 4 * kSquare_m},
        b = a + Vec2{kSquare_m, 0}, c = a + Vec2{kSquare_m, kSquare_m}, d = a + Vec2{0, kSquare_m};
    halve(field, {b, c, a}, halved), halve(field, {d, a, c}, halved);
  }
  return {is_within(field, halved), is_within(field, refined_mesh(field))};
}

}  // namespace citykiln::charts
