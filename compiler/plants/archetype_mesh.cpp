#include <algorithm>
#include <array>
#include <map>

#include "compiler/contract/draw.h"
#include "compiler/geometry/trig.h"
#include "compiler/plants/expand.h"

namespace citykiln::plants {
namespace {

using materials::DressedMesh;
using materials::Material;

// A sphere of triangles: an octahedron, each face cut in four `times` times.
Mesh sphere(int times) {
  Mesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int t = 0; t < times; ++t) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(unit(mesh.positions[a] + mesh.positions[b]));
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  mesh.normals = mesh.positions;
  return mesh;
}

// One lump of a crown: a sphere dented by chance. The same vertex is dented alike at every subdivision.
constexpr double kDent = 0.16;
Mesh lump(Vec3 centre, Vec3 radii, int times, std::uint32_t number) {
  Mesh mesh = sphere(times);
  const Draw draw(1, stable_id(ObjectId{{OsmType::kNone, 0}, number}), "lump");
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 d = mesh.positions[i];
    const double r = 1 - kDent * draw.unit(i);
    mesh.positions[i] = centre + Vec3{d.x * radii.x, d.y * radii.y, d.z * radii.z} * r;
    // rounder than the shape: normals blown up from a point below the crown's middle light leaves as a mass
    mesh.normals[i] = unit(unit(Vec3{d.x / radii.x, d.y / radii.y, d.z / radii.z}) + unit(mesh.positions[i] - Vec3{0, 0, 0.45}) * 0.8);
  }
  return mesh;
}

void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  for (const Triangle& t : more.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// An upright cone stump, open at both ends.
Mesh stump(int sides, double bottom_z, double top_z, double bottom_radius, double top_radius, double turn = 0) {
  Mesh mesh;
  for (int i = 0; i < sides; ++i) {
    const Vec2 d = direction_of((i + turn) / sides);
    const Vec3 normal = unit(at_height(d, (bottom_radius - top_radius) / (top_z - bottom_z)));
    mesh.positions.push_back(at_height(d * bottom_radius, bottom_z)), mesh.positions.push_back(at_height(d * top_radius, top_z));
    mesh.normals.push_back(normal), mesh.normals.push_back(normal);
  }
  const auto n = static_cast<std::uint32_t>(2 * sides);
  for (std::uint32_t i = 0; i < n; i += 2) {
    const std::uint32_t j = (i + 2) % n;
    mesh.triangles.push_back({i, j, j + 1});
    mesh.triangles.push_back({i, j + 1, i + 1});
  }
  return mesh;
}

// A skirt of branches: a cone to a tip, its rim drooping in and out by turns.
Mesh skirt(int sides, double bottom_z, double top_z, double radius, std::uint32_t number) {
  Mesh mesh;
  const Draw draw(1, stable_id(ObjectId{{OsmType::kNone, 0}, 100 + number}), "skirt");
  mesh.positions.push_back({0, 0, top_z}), mesh.normals.push_back({0, 0, 1});
  for (int i = 0; i < sides; ++i) {
    const Vec2 d = direction_of((i + draw.unit(200)) / sides);
    const double r = radius * (1 - 0.25 * draw.unit(static_cast<std::uint32_t>(i)));
    mesh.positions.push_back(at_height(d * r, bottom_z + 0.03 * draw.unit(static_cast<std::uint32_t>(100 + i))));
    mesh.normals.push_back(unit(at_height(d, 0.45)));
  }
  const auto n = static_cast<std::uint32_t>(sides);
  mesh.positions.push_back({0, 0, bottom_z + 0.04}), mesh.normals.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    mesh.triangles.push_back({n + 1, 1 + (i + 1) % n, 1 + i});
  }
  return mesh;
}

// The shapes at one fineness: 2 is full, 1 and 0 are cut. Metres for a tree 1 m tall.
std::vector<DressedMesh> broad_leaved(int fineness) {
  struct Lump {
    Vec3 centre, radii;
  };
  constexpr Lump kLumps[] = {{{0, 0, 0.66}, {0.30, 0.30, 0.33}}, {{0.15, 0.06, 0.54}, {0.21, 0.20, 0.21}}, {{-0.13, 0.12, 0.57}, {0.20, 0.20, 0.22}},
                             {{-0.04, -0.16, 0.55}, {0.22, 0.20, 0.20}}, {{0.06, 0.04, 0.80}, {0.19, 0.19, 0.19}}};
  DressedMesh crown{{}, Material::kBroadLeaf, materials::kNoTint, {}}, trunk{{}, Material::kBark, materials::kNoTint, {}};
  const std::size_t lumps = fineness == 0 ? 1 : std::size(kLumps);
  for (std::size_t i = 0; i < lumps; ++i) append(crown.mesh, lump(kLumps[i].centre, kLumps[i].radii, fineness == 2 ? 2 : 1, static_cast<std::uint32_t>(i)));
  append(trunk.mesh, stump(fineness == 2 ? 6 : 4, -0.05, 0.5, 0.028, 0.018));
  return {std::move(trunk), std::move(crown)};
}

std::vector<DressedMesh> needle_leaved(int fineness) {
  DressedMesh crown{{}, Material::kNeedleLeaf, materials::kNoTint, {}}, trunk{{}, Material::kBark, materials::kNoTint, {}};
  const int skirts = fineness == 2 ? 6 : fineness == 1 ? 3 : 1, sides = fineness == 2 ? 11 : fineness == 1 ? 7 : 5;
  for (int i = 0; i < skirts; ++i) {
    const double bottom = 0.12 + 0.76 * i / skirts, reach = 0.19 * (1 - 0.86 * i / skirts);
    append(crown.mesh, skirt(sides, bottom, std::min(1.0, bottom + 1.5 * 0.88 / skirts), reach, static_cast<std::uint32_t>(i)));
  }
  append(trunk.mesh, stump(fineness == 2 ? 6 : 4, -0.05, 0.3, 0.022, 0.014));
  return {std::move(trunk), std::move(crown)};
}

// What is lost by a cut, for a tree 1 m tall: the farthest that a point of either shape lies from the other. Bounds by the parts left out: a side lump sticks out of the
// middle one by less than its distance and radius beyond it; a finer sphere leaves a coarser one by its dents and the coarser one's sag.
constexpr std::array<double, 3> kBroadErrors = {0.21, 0.075, 0}, kNeedleErrors = {0.16, 0.085, 0};

}  // namespace

ArchetypeMesh archetype_mesh(Archetype archetype, double height_m, double tolerance_m) {
  if (height_m <= tolerance_m) return {{}, 1};
  const bool is_broad = archetype == Archetype::kBroadLeaved;
  const auto& errors = is_broad ? kBroadErrors : kNeedleErrors;
  int fineness = 0;
  while (fineness < 2 && errors[static_cast<std::size_t>(fineness)] * height_m > tolerance_m) ++fineness;
  return {is_broad ? broad_leaved(fineness) : needle_leaved(fineness), errors[static_cast<std::size_t>(fineness)]};
}

}  // namespace citykiln::plants
