#include "compiler/buildings/expand.h"

#include <algorithm>

#include "compiler/contract/draw.h"
#include "compiler/geometry/triangulate.h"

namespace citykiln::buildings {
namespace {

using materials::DressedMesh;
using materials::Material;
using materials::Tint;

// Washes of lime as old towns have them, as factors of plaster's colour: white, cream, ochre, rose, grey, pale green.
constexpr double kWashes[][3] = {{1.0, 1.0, 1.0}, {1.0, 0.96, 0.84}, {0.96, 0.83, 0.60}, {0.97, 0.78, 0.68}, {0.80, 0.82, 0.84}, {0.84, 0.88, 0.74}, {1.0, 0.90, 0.72}};

std::uint8_t byte_of(double v) { return static_cast<std::uint8_t>(std::clamp(v, 0.0, 1.0) * 255 + 0.5); }

// The factor that turns a material's colour into the tagged one, as far as a factor of at most 1 can.
Tint tint_to(Material material, map::Srgb colour) {
  Tint tint = materials::kNoTint;
  for (int c = 0; c < 3; ++c) tint[c] = byte_of(materials::linear_of_srgb(colour[c]) / values_of(material).base_colour[c]);
  return tint;
}

Tint drawn_tint(Material material, const Draw& draw) {
  const double level = 1 - 2 * values_of(material).variation * draw.unit(0);
  Tint tint = materials::kNoTint;
  const double* wash = kWashes[draw.below(std::size(kWashes), 1)];
  for (int c = 0; c < 3; ++c) tint[c] = byte_of(level * (material == Material::kPlaster ? wash[c] : 1));
  return tint;
}

// A tagged colour brighter than the material can become is painted plaster.
Material paintable(Material material, const std::optional<map::Srgb>& colour) {
  if (!colour) return material;
  for (int c = 0; c < 3; ++c)
    if (materials::linear_of_srgb((*colour)[c]) > values_of(material).base_colour[c]) return Material::kPaint;
  return material;
}

DressedMesh dressed(const Building& building, Material material, const std::optional<map::Srgb>& colour, const Draw& draw) {
  const Material painted = paintable(material, colour);
  return {{}, painted, colour ? tint_to(painted, *colour) : drawn_tint(material, draw), building.id.osm};
}

void add_walls(Mesh& mesh, const Ring& ring, double bottom_m, double top_m) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto count = static_cast<std::uint32_t>(ring.size());
  for (const Vec2 p : ring) mesh.positions.push_back(at_height(p, bottom_m)), mesh.positions.push_back(at_height(p, top_m));
  for (std::uint32_t i = 0; i < count; ++i) {
    // counter-clockwise from outside: outer rings have it on their right, holes too, as they run the other way
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % count);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
}

// The footprint at a height, looking up or down.
void add_slab(Mesh& mesh, const PlaneTriangles& plan, double height_m, bool looks_up) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec2 p : plan.points) mesh.positions.push_back(at_height(p, height_m));
  for (Triangle t : plan.triangles) {
    if (!looks_up) std::swap(t[1], t[2]);
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace

Expanded expand(const Building& building, std::uint64_t seed, double tolerance_m) {
  const double height_m = building.top_m - building.bottom_m;
  if (height_m <= tolerance_m) return {{}, height_m};
  const StableId id = stable_id(building.id);
  DressedMesh walls = dressed(building, building.wall, building.wall_colour, Draw(seed, id, "wall"));
  DressedMesh roof = dressed(building, building.roof, building.roof_colour, Draw(seed, id, "roof"));
  add_walls(walls.mesh, building.footprint.outer, building.bottom_m, building.top_m);
  for (const Ring& hole : building.footprint.holes) add_walls(walls.mesh, hole, building.bottom_m, building.top_m);
  const PlaneTriangles plan = triangulate(building.footprint);
  add_slab(roof.mesh, plan, building.top_m, true);
  // what stands on the ground needs no floor
  if (!building.stands_on_ground) add_slab(walls.mesh, plan, building.bottom_m, false);
  return {{std::move(walls), std::move(roof)}, 0};
}

}  // namespace citykiln::buildings
