#include "compiler/structures/loft.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/triangles/triangulate.h"

namespace citykiln::structures {
namespace {

std::uint32_t first_of_next(const Mesh& mesh) { return static_cast<std::uint32_t>(mesh.positions.size()); }

// A convex ring at one height.
void add_fan(std::span<const Vec2> base, double z_m, bool looks_up, Mesh& mesh) {
  const std::uint32_t first = first_of_next(mesh);
  for (const Vec2 p : base) mesh.positions.push_back(snapped(at_height(p, z_m)));
  for (std::uint32_t i = 2; i < base.size(); ++i) {
    const std::uint32_t a = first + i - 1, b = first + i;
    mesh.triangles.push_back(looks_up ? Triangle{first, a, b} : Triangle{first, b, a});
  }
}

}  // namespace

void add_band(std::span<const Rib> ribs, Corner a, Corner b, Mesh& mesh) {
  for (std::size_t i = 0; i < ribs.size(); ++i) {
    const std::uint32_t next = first_of_next(mesh);
    mesh.positions.push_back(point_on(ribs[i], a.left_m, a.rise_m));
    mesh.positions.push_back(point_on(ribs[i], b.left_m, b.rise_m));
    if (i > 0) add_quad(mesh, next - 2, next - 1, next + 1, next);
  }
}

void add_cap(const Rib& rib, const Section& section, bool is_begin, Mesh& mesh) {
  Polygon polygon;
  for (const Corner& c : section) polygon.outer.push_back({c.left_m, c.rise_m});
  const PlaneTriangles cap = triangulate(polygon);
  const std::uint32_t first = first_of_next(mesh);
  for (const Vec2 p : cap.points) mesh.positions.push_back(point_on(rib, p.x, p.y));
  // the plane of (left, rise) is mirrored for a viewer who looks along the axis
  for (const auto& [a, b, c] : cap.triangles)
    mesh.triangles.push_back(is_begin ? Triangle{first + a, first + c, first + b}
                                      : Triangle{first + a, first + b, first + c});
}

void add_tube(std::span<const Rib> ribs, const Section& section, Mesh& mesh) {
  if (ribs.size() < 2) return;
  for (std::size_t i = 0; i < section.size(); ++i) add_band(ribs, section[i], section[(i + 1) % section.size()], mesh);
  add_cap(ribs.front(), section, true, mesh);
  add_cap(ribs.back(), section, false, mesh);
}

Rib rib_at(std::span<const Rib> ribs, double along_m) {
  assert(!ribs.empty());
  const auto next = std::ranges::upper_bound(ribs, along_m, {}, &Rib::along_m);
  if (next == ribs.begin()) return ribs.front();
  if (next == ribs.end()) return ribs.back();
  const Rib &a = next[-1], &b = *next;
  const double t = (along_m - a.along_m) / (b.along_m - a.along_m);
  const auto mix = [&](auto from, auto to) { return from + (to - from) * t; };
  return {.at = mix(a.at, b.at),
          .out = mix(a.out, b.out),
          .z_m = mix(a.z_m, b.z_m),
          .tilt = mix(a.tilt, b.tilt),
          .along_m = along_m};
}

void add_prism(std::span<const Vec2> base, double from_m, double to_m, Mesh& mesh) {
  assert(base.size() >= 3 && from_m <= to_m);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Vec2 a = base[i], b = base[(i + 1) % base.size()];
    const std::uint32_t first = first_of_next(mesh);
    for (const Vec3 p : {at_height(a, from_m), at_height(b, from_m), at_height(b, to_m), at_height(a, to_m)})
      mesh.positions.push_back(snapped(p));
    add_quad(mesh, first, first + 1, first + 2, first + 3);
  }
  add_fan(base, from_m, false, mesh);
  add_fan(base, to_m, true, mesh);
}

}  // namespace citykiln::structures
