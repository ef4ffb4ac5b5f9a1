#include "lsystems/mesh/leaves.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace citykiln::lsystems {
namespace {

bool is_convex(std::span<const Vec2> ring) {
  double turns_x = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    if (cross(b - a, c - b) < 0) return false;
    turns_x += (b.x - a.x >= 0) != (c.x - b.x >= 0) ? 1 : 0;
  }
  // a ring that winds twice also turns left everywhere
  return turns_x <= 2;
}

bool is_inside(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0;
}

bool is_ear(std::span<const Vec2> ring, const std::vector<std::uint32_t>& left, std::size_t at) {
  const std::size_t n = left.size(), before = (at + n - 1) % n, after = (at + 1) % n;
  const Vec2 a = ring[left[before]], b = ring[left[at]], c = ring[left[after]];
  if (cross(b - a, c - b) <= 0) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = ring[left[i]];
    if (i != before && i != at && i != after && p != a && p != b && p != c && is_inside(p, a, b, c)) return false;
  }
  return true;
}

// The mean plane of a polygon, with axes across and along the leaf.
struct Plane {
  Vec3 normal, across, along;
  Vec2 of(Vec3 p) const { return {dot(p, across), dot(p, along)}; }
};

Plane plane_of(std::span<const Vec3> corners) {
  Vec3 area, middle;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    area = area + cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    middle = middle + (corners[i] - corners[0]) * (1.0 / static_cast<double>(corners.size()));
  }
  Plane plane;
  plane.normal = unit(area);
  // a leaf extends from its first corner through its centre to its tip
  const Vec3 along = unit(middle - plane.normal * dot(plane.normal, middle));
  plane.along = length(along) > 0.5 ? along : unit(cross(plane.normal, {0, 0.6, 0.8}));
  plane.across = cross(plane.along, plane.normal);
  return plane;
}

struct Bounds {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double extent() const { return std::max(high.x - low.x, high.y - low.y); }
  Vec2 within(Vec2 p) const {
    const Vec2 size = high - low;
    return {size.x > 0 ? (p.x - low.x) / size.x : 0, size.y > 0 ? (p.y - low.y) / size.y : 0};
  }
};

bool add_polygon(std::span<const Vec3> corners, double tolerance_m, std::vector<Vec2>& ring, PartMesh& mesh) {
  const Plane plane = plane_of(corners);
  if (!(length(plane.normal) > 0.5)) return false;
  ring.clear();
  Bounds frame;
  for (const Vec3 corner : corners) frame.add(ring.emplace_back(plane.of(corner - corners[0])));
  if (frame.extent() <= tolerance_m) return false;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    mesh.positions.push_back(corners[i]);
    mesh.normals.push_back(plane.normal);
    mesh.uvs.push_back(frame.within(ring[i]));
  }
  for (const Triangle& t : triangulate_ring(ring)) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return true;
}

// The default surface: a kite, narrow at the stalk, widest below the middle.
const LeafSurface& card() {
  static const LeafSurface kCard{{{0, 0, 0}, {-0.3, 0.4, 0}, {0, 1, 0}, {0.3, 0.4, 0}},
                                 {{0.5, 0}, {1, 0.4}, {0.5, 1}, {0, 0.4}},
                                 {{0, 1, 2}, {0, 2, 3}}};
  return kCard;
}

void add_normals(const LeafSurface& surface, std::uint32_t first, PartMesh& mesh, Vec3 otherwise) {
  for (const Triangle& t : surface.triangles) {
    const Vec3 a = mesh.positions[first + t[0]];
    const Vec3 area = cross(mesh.positions[first + t[1]] - a, mesh.positions[first + t[2]] - a);
    for (const std::uint32_t corner : t) mesh.normals[first + corner] = mesh.normals[first + corner] + area;
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  for (std::size_t i = first; i < mesh.normals.size(); ++i) {
    const Vec3 normal = unit(mesh.normals[i]);
    mesh.normals[i] = length(normal) > 0.5 ? normal : otherwise;
  }
}

bool add_instance(const Instance& instance, const LeafSurface& surface, double tolerance_m, PartMesh& mesh) {
  double extent = 0;
  for (const Vec3 p : surface.positions) extent = std::max(extent, length(p - surface.positions[0]));
  if (!(extent * std::abs(instance.size) > tolerance_m)) return false;
  const TurtleFrame& f = instance.frame;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Vec3 p = surface.positions[i] * instance.size;
    mesh.positions.push_back(f.at + f.left * p.x + f.heading * p.y + f.up * p.z);
    mesh.normals.push_back({});
    mesh.uvs.push_back(i < surface.uvs.size() ? surface.uvs[i] : Vec2{});
  }
  add_normals(surface, first, mesh, f.up);
  return true;
}

}  // namespace

std::vector<Triangle> triangulate_ring(std::span<const Vec2> ring) {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> left(ring.size());
  std::iota(left.begin(), left.end(), 0U);
  const bool is_easy = ring.size() > kMostClipped || is_convex(ring);
  std::size_t at = 0;
  for (std::size_t failed = 0; !is_easy && left.size() > 3 && failed < left.size();) {
    const std::size_t n = left.size();
    if (!is_ear(ring, left, at % n)) {
      ++failed, ++at;
      continue;
    }
    triangles.push_back({left[(at + n - 1) % n], left[at % n], left[(at + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at % n));
    failed = 0;
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
  return triangles;
}

void mesh_leaves(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& out) {
  std::vector<Vec2> ring;
  for (const FlatPolygon& polygon : skeleton.polygons) {
    const std::span<const Vec3> corners(skeleton.vertices.data() + polygon.first, polygon.count);
    if (!add_polygon(corners, options.tolerance_m, ring, out.leaf)) ++out.left_out;
  }
  if (!options.instances) return;
  for (const Instance& instance : skeleton.instances) {
    const bool is_named = instance.kind < options.surfaces.size() && !options.surfaces[instance.kind].positions.empty();
    const LeafSurface& surface = is_named ? options.surfaces[instance.kind] : card();
    if (!add_instance(instance, surface, options.tolerance_m, out.leaf)) ++out.left_out;
  }
}

}  // namespace citykiln::lsystems
