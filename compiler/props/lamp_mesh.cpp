// Street lamps as meshes: lamp_mesh() of generate.h.
#include <array>
#include <cassert>
#include <utility>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/props/generate.h"

namespace citykiln::props {
namespace {

using materials::Material;
using materials::MaterialMesh;

// A cross-section, counter-clockwise seen from its last neighbour.
using Section = std::vector<Vec3>;

// Errors of the three levels of detail of a lamp of 1 m, finest first: Hausdorff distances to the first, both ways,
// measured by lamp_mesh_test.cpp and rounded up.
using Details = std::array<double, 3>;
constexpr Details kPostTopErrors = {0, 0.0105, 0.023}, kArmErrors = {0, 0.0065, 0.025};

// Depth below the ground, which slopes and coarse levels may lower.
constexpr double kLampFoot_m = -0.03;

// Adds the closed surface through cross-sections of equal size.
void add_loft(Mesh& mesh, const std::vector<Section>& sections) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto n = static_cast<std::uint32_t>(sections.front().size());
  for (const Section& section : sections)
    for (const Vec3 p : section) mesh.positions.push_back(snapped(p));
  const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - n;
  for (std::uint32_t ring = first; ring < last; ring += n)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = ring + i, b = ring + (i + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({first, first + i + 1, first + i});
    mesh.triangles.push_back({last, last + i, last + i + 1});
  }
}

// A horizontal regular polygon around the z axis, with a vertex towards +x.
Section polygon(int sides, double z_m, double radius_m) {
  Section section;
  for (int i = 0; i < sides; ++i)
    section.push_back(at_height(direction_of(static_cast<double>(i) / sides) * radius_m, z_m));
  return section;
}

void add_tube(Mesh& mesh, int sides, double bottom_m, double top_m, double bottom_radius_m, double top_radius_m) {
  add_loft(mesh, {polygon(sides, bottom_m, bottom_radius_m), polygon(sides, top_m, top_radius_m)});
}

// A vertical rectangle, square to the x axis.
Section rectangle(double x_m, double low_m, double high_m, double half_width_m) {
  return {{x_m, -half_width_m, low_m},
          {x_m, half_width_m, low_m},
          {x_m, half_width_m, high_m},
          {x_m, -half_width_m, high_m}};
}

// A vertical triangle with its vertex below, square to the x axis.
Section triangle(double x_m, double low_m, double high_m, double half_width_m) {
  return {{x_m, 0, low_m}, {x_m, half_width_m, high_m}, {x_m, -half_width_m, high_m}};
}

// The lower part, with the access door, is wider.
void add_pole(Mesh& mesh, int detail, double top_m) {
  if (detail == 0) {
    add_tube(mesh, 5, kLampFoot_m, 0.125, 0.0105, 0.0105);
    add_tube(mesh, 5, 0.125, top_m, 0.0075, 0.0045);
  } else {
    add_tube(mesh, 3, kLampFoot_m, top_m, 0.0115, 0.0055);
  }
}

void add_lantern(Mesh& metal, Mesh& glass, int detail) {
  if (detail == 2) return add_tube(metal, 4, 0.90, 1, 0.022, 0.022);
  const int sides = detail == 0 ? 6 : 4;
  add_tube(glass, sides, 0.90, 0.965, 0.016, 0.034);
  add_tube(metal, sides, 0.965, 1, 0.040, 0.010);
}

void add_arm(Mesh& metal, Mesh& glass, int detail) {
  if (detail == 2) return add_loft(metal, {triangle(0, 0.94, 0.965, 0.005), triangle(0.21, 0.982, 1, 0.014)});
  if (detail == 1) {
    add_loft(metal, {triangle(0, 0.94, 0.948, 0.004), triangle(0.03, 0.972, 0.98, 0.004),
                     triangle(0.13, 0.986, 0.994, 0.004)});
    add_loft(metal, {rectangle(0.12, 0.98, 1, 0.012), rectangle(0.21, 0.98, 0.994, 0.014)});
    return;
  }
  add_loft(metal, {rectangle(0, 0.94, 0.947, 0.0035), rectangle(0.03, 0.972, 0.979, 0.0035),
                   rectangle(0.13, 0.987, 0.994, 0.0035)});
  add_loft(metal, {rectangle(0.12, 0.984, 1, 0.011), rectangle(0.21, 0.984, 0.994, 0.015)});
  add_loft(glass, {rectangle(0.14, 0.98, 0.986, 0.009), rectangle(0.205, 0.98, 0.986, 0.013)});
}

}  // namespace

GeneratedProp lamp_mesh(LampKind kind, double height_m, double tolerance_m, bool is_lit) {
  assert(height_m >= 0 && tolerance_m >= 0);
  if (height_m <= tolerance_m) return {{}, height_m};
  const bool has_arm = kind == LampKind::kArm;
  const Details& errors = has_arm ? kArmErrors : kPostTopErrors;
  int detail = 2;
  while (errors[detail] * height_m > tolerance_m) --detail;
  MaterialMesh metal{{}, Material::kPaintedMetal, materials::kNoTint, {}},
      glass{{}, is_lit ? Material::kLitLampGlass : Material::kLampGlass, materials::kNoTint, {}};
  add_pole(metal.mesh, detail, has_arm ? 0.955 : 0.91);
  has_arm ? add_arm(metal.mesh, glass.mesh, detail) : add_lantern(metal.mesh, glass.mesh, detail);
  GeneratedProp lamp{{std::move(metal)}, errors[detail] * height_m};
  if (!glass.mesh.triangles.empty()) lamp.meshes.push_back(std::move(glass));
  return lamp;
}

}  // namespace citykiln::props
