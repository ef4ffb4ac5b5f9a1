#include "compiler/structures/plate_mesh.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/triangles/triangulate.h"

namespace citykiln::structures {
namespace {

// Roads lie in a step of this depth, so that kerbs and carriageways are above the slab.
constexpr double kRoadStep_m = 0.25;

using PlateRing = std::vector<PlateCorner>;

Polygon plan_of(const PlatePart& part) {
  Polygon plan;
  for (std::size_t r = 0; r < part.rings.size(); ++r) {
    Ring& ring = r == 0 ? plan.outer : plan.holes.emplace_back();
    for (const PlateCorner& corner : part.rings[r]) ring.push_back(in_plan(corner.at));
  }
  return plan;
}

// The heights of the points that triangulate() returns: corners in order; rings do not cross.
std::vector<double> heights_of(const PlatePart& part, std::size_t points) {
  std::vector<double> heights;
  for (const PlateRing& ring : part.rings)
    for (const PlateCorner& corner : ring) heights.push_back(corner.at.z);
  heights.resize(std::max(points, heights.size()), heights.empty() ? 0 : heights.back());
  return heights;
}

// One side of a part, by its height below the top.
void add_side(const PlaneTriangles& plane, const std::vector<double>& heights, double below_m, bool looks_up,
              Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < plane.points.size(); ++i)
    mesh.positions.push_back(snapped(at_height(plane.points[i], heights[i] - below_m)));
  for (const auto& [a, b, c] : plane.triangles)
    mesh.triangles.push_back(looks_up ? Triangle{first + a, first + b, first + c}
                                      : Triangle{first + a, first + c, first + b});
}

void add_faces(const PlateRing& ring, double from_m, double to_m, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto count = static_cast<std::uint32_t>(ring.size());
  for (const PlateCorner& corner : ring)
    for (const double below_m : {to_m, from_m})
      mesh.positions.push_back(snapped(at_height(in_plan(corner.at), corner.at.z - below_m)));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % count);
    add_quad(mesh, a, b, b + 1, a + 1);
  }
}

materials::Material top_material(const Plate& plate, const PlatePart& part) {
  if (part.is_below_road || plate.surface == map::LandCoverClass::kUnknown) return materials::Material::kConcrete;
  return map::values_of(plate.surface).material;
}

Rib wall_rib(Vec3 at, Vec2 before, Vec2 after, double along_m) {
  // a mitre, at most twice as long as the wall is wide
  const Vec2 sum = left_of(before) + left_of(after);
  const double twice = dot(sum, sum) / 2;
  const Vec2 out = twice > 0.5 ? sum * (1 / twice) : left_of(after);
  return {.at = in_plan(at), .out = out, .z_m = at.z, .tilt = 0, .along_m = along_m};
}

void add_run(const PlateRing& ring, std::size_t from, std::size_t edges, std::vector<std::vector<Rib>>& runs) {
  const auto at = [&](std::size_t i) { return ring[(from + i) % ring.size()].at; };
  const auto direction = [&](std::size_t edge) { return unit(in_plan(at(edge + 1)) - in_plan(at(edge))); };
  const bool is_closed = edges == ring.size();
  std::vector<Rib>& run = runs.emplace_back();
  double along_m = 0;
  for (std::size_t i = 0; i <= edges; ++i) {
    const Vec2 before = direction(i > 0       ? i - 1
                                  : is_closed ? edges - 1
                                              : 0),
               after = direction(i < edges   ? i
                                 : is_closed ? 0
                                             : edges - 1);
    run.push_back(wall_rib(at(i), before, after, along_m));
    if (i < edges) along_m += distance(in_plan(at(i)), in_plan(at(i + 1)));
  }
}

}  // namespace

std::vector<std::vector<Rib>> wall_runs(const Plate& plate) {
  std::vector<std::vector<Rib>> runs;
  for (const PlatePart& part : plate.parts)
    for (const PlateRing& ring : part.rings) {
      const auto open = std::ranges::find(ring, false, &PlateCorner::has_wall);
      if (open == ring.end()) {
        if (ring.size() > 2) add_run(ring, 0, ring.size(), runs);
        continue;
      }
      const auto start = static_cast<std::size_t>(open - ring.begin());
      for (std::size_t i = 1; i < ring.size();) {
        std::size_t n = 0;
        while (i + n < ring.size() && ring[(start + i + n) % ring.size()].has_wall) ++n;
        if (n > 0) add_run(ring, start + i, n, runs);
        i += n + 1;
      }
    }
  return runs;
}

void add_plate(const Plate& plate, const DeckDimensions& shape, PlateDetail detail, GeneratedStructure& generated) {
  assert(detail.has_slab || !detail.has_parapets);
  Mesh concrete;
  for (const PlatePart& part : plate.parts) {
    const PlaneTriangles plane = triangulate(plan_of(part));
    const std::vector<double> heights = heights_of(part, plane.points.size());
    const double step_m = part.is_below_road ? kRoadStep_m : 0;
    materials::MaterialMesh top{{}, top_material(plate, part), materials::kNoTint, plate.id};
    add_side(plane, heights, step_m, true, top.mesh);
    generated.meshes.push_back(std::move(top));
    if (!detail.has_slab) continue;
    add_side(plane, heights, shape.thickness_m, false, concrete);
    for (const PlateRing& ring : part.rings) add_faces(ring, step_m, shape.thickness_m, concrete);
  }
  if (detail.has_parapets)
    for (const std::vector<Rib>& run : wall_runs(plate))
      add_tube(run, {{kParapet_m, 0}, {kParapet_m, shape.parapet_m}, {0, shape.parapet_m}, {0, 0}}, concrete);
  if (!concrete.triangles.empty())
    generated.meshes.push_back({std::move(concrete), materials::Material::kConcrete, materials::kNoTint, plate.id});
}

}  // namespace citykiln::structures
