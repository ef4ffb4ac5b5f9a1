#include "compiler/plants/tree_parts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/contract/draw.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::plants {
namespace {

// How deep dents are, as a share of the radius, and how far rims draw back: enough to break the outline, not the shape.
constexpr double kFineDent = 0.11, kRimDent = 0.28, kDroop_m = 0.03;

// How much a normal follows the crown as a whole.
constexpr double kHeartShare = 0.4;

Draw dice(const char* part, std::uint32_t number) { return Draw(1, stable_id(ObjectId{{}, number}), part); }

std::uint32_t push(Mesh& mesh, Vec3 position, Vec3 normal) {
  mesh.positions.push_back(snapped(position));
  mesh.normals.push_back(normal);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

constexpr std::uint32_t kCorners = 12;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Directions of an icosahedron's corners, then of its edges' middles where it is cut finer.
struct Icosphere {
  std::vector<Vec3> directions;
  std::vector<Edge> edges;  // whose middles the directions from kCorners on are
  std::vector<Triangle> triangles;
};

Icosphere icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;  // the golden ratio
  Icosphere sphere{{{-1, g, 0},
                    {1, g, 0},
                    {-1, -g, 0},
                    {1, -g, 0},
                    {0, -1, g},
                    {0, 1, g},
                    {0, -1, -g},
                    {0, 1, -g},
                    {g, 0, -1},
                    {g, 0, 1},
                    {-g, 0, -1},
                    {-g, 0, 1}},
                   {},
                   {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Vec3& d : sphere.directions) d = unit(d);
  return sphere;
}

Icosphere finer(Icosphere sphere) {
  std::map<Edge, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(sphere.directions.size()));
    if (is_new) {
      sphere.directions.push_back(unit(sphere.directions[a] + sphere.directions[b]));
      sphere.edges.push_back(entry->first);
    }
    return entry->second;
  };
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : sphere.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  sphere.triangles = std::move(triangles);
  return sphere;
}

// Shares of the radius: corners by chance, middles about the mean of their ends.
std::vector<double> dented(const Icosphere& sphere, double dent, std::uint32_t number) {
  const Draw draw = dice("lump", number);
  std::vector<double> shares;
  for (std::uint32_t i = 0; i < kCorners; ++i) shares.push_back(1 - dent * draw.unit(i));
  for (std::uint32_t i = 0; i < sphere.edges.size(); ++i) {
    const auto [a, b] = sphere.edges[i];
    shares.push_back((shares[a] + shares[b]) / 2 - kFineDent * draw.unit(kCorners + i));
  }
  return shares;
}

}  // namespace

void add_lump(Mesh& mesh, Vec3 centre, Vec3 radii, double dent, bool is_fine, Vec3 heart, std::uint32_t number) {
  const Icosphere sphere = is_fine ? finer(icosahedron()) : icosahedron();
  const std::vector<double> shares = dented(sphere, dent, number);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Vec3 d = sphere.directions[i];
    const Vec3 at = centre + Vec3{d.x * radii.x, d.y * radii.y, d.z * radii.z} * shares[i];
    const Vec3 own = unit(Vec3{d.x / radii.x, d.y / radii.y, d.z / radii.z});
    push(mesh, at, unit(own * (1 - kHeartShare) + unit(at - heart) * kHeartShare));
  }
  for (const Triangle& t : sphere.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void add_skirt(Mesh& mesh, int sides, double rim_z, double tip_z, double radius, std::uint32_t number) {
  const Draw draw = dice("skirt", number);
  const double start = draw.unit(0);
  const std::uint32_t tip = push(mesh, {0, 0, tip_z}, {0, 0, 1});
  const std::uint32_t hollow = push(mesh, {0, 0, rim_z + (tip_z - rim_z) * 0.2}, {0, 0, -1});
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec2 out = direction_of((i + start) / sides);
    const double reach = radius * (1 - kRimDent * draw.unit(1 + 2 * i));
    const Vec3 rim = at_height(out * reach, rim_z - kDroop_m * draw.unit(2 + 2 * i));
    push(mesh, rim, unit(at_height(out, radius / (tip_z - rim_z))));
    push(mesh, rim, unit(at_height(out * 0.3, -1)));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = hollow + 1 + 2 * i, b = hollow + 1 + 2 * ((i + 1) % n);
    mesh.triangles.push_back({tip, a, b});
    mesh.triangles.push_back({hollow, b + 1, a + 1});
  }
}

void add_trunk(Mesh& mesh, int sides, double bottom_z, double top_z, double bottom_radius, double top_radius) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size()), n = static_cast<std::uint32_t>(sides);
  for (int i = 0; i < sides; ++i) {
    const Vec2 out = direction_of(static_cast<double>(i) / sides);
    const Vec3 normal = unit(at_height(out, (bottom_radius - top_radius) / (top_z - bottom_z)));
    push(mesh, at_height(out * bottom_radius, bottom_z), normal);
    push(mesh, at_height(out * top_radius, top_z), normal);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
}

}  // namespace citykiln::plants
