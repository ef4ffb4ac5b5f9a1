#include "compiler/plants/tufts/tuft_mesh.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/trig.h"

namespace citykiln::plants {
namespace {

using materials::Material;
using materials::MaterialMesh;
using materials::Tint;

// Feet of blades stand this far below the ground, whose mesh may be lower than its heights.
constexpr double kBuried = 0.25;
// Brightness of a blade's foot, which stands in the shade of others, and of its tip.
constexpr double kFootShade = 0.75, kTipShade = 1.3;

constexpr LeafColour kWhitePetal = {0.80, 0.78, 0.74}, kYellowPetal = {0.80, 0.55, 0.02},
                     kPinkPetal = {0.68, 0.58, 0.55}, kEar = {0.33, 0.29, 0.14};

Tint tint_for(Material material, const LeafColour& colour, double shade) {
  const auto& base = values_of(material).base_colour;
  const auto byte = [shade](double wanted, float whole) {
    return static_cast<std::uint8_t>(std::clamp(255 * wanted * shade / static_cast<double>(whole), 0.0, 255.0) + 0.5);
  };
  return {byte(colour.red, base[0]), byte(colour.green, base[1]), byte(colour.blue, base[2]), 255};
}

// A mesh of one material, while it is drawn.
struct Drawn {
  MaterialMesh mesh;
  explicit Drawn(Material material) { mesh.material = material; }

  std::uint32_t vertex(Vec3 at, Vec3 normal, const LeafColour& colour, double shade) {
    mesh.mesh.positions.push_back(at), mesh.mesh.normals.push_back(unit(normal));
    mesh.tints.push_back(tint_for(mesh.material, colour, shade));
    return static_cast<std::uint32_t>(mesh.mesh.positions.size() - 1);
  }
};

// A blade that leans over.
struct Blade {
  Vec2 foot, lean;  // lean is a unit vector
  double from = 0, height = 1, bend = 0, width = 0;
};

void draw_blade(Drawn& drawn, const Blade& blade, const LeafColour& colour) {
  const Vec2 side = left_of(blade.lean) * (blade.width / 2), middle = blade.foot + blade.lean * (0.3 * blade.bend);
  const double middle_z = blade.from + 0.6 * (blade.height - blade.from), tip_z = blade.height;
  const Vec3 normal = at_height(blade.lean * 0.4, 1);
  const auto corner = [&](Vec2 at, double z, double shade) {
    return drawn.vertex(at_height(at, z), normal, colour, shade);
  };
  const std::uint32_t a = corner(blade.foot - side, blade.from, kFootShade),
                      b = corner(blade.foot + side, blade.from, kFootShade),
                      c = corner(middle - side * 0.8, middle_z, 1), d = corner(middle + side * 0.8, middle_z, 1),
                      tip = corner(blade.foot + blade.lean * blade.bend, tip_z, kTipShade);
  drawn.mesh.mesh.triangles.insert(drawn.mesh.mesh.triangles.end(), {{a, b, d}, {a, d, c}, {c, d, tip}});
}

// A flat or domed round of petals, seen from above.
struct Round {
  Vec3 middle;
  double radius = 0, rim_z = 0;
  int corners = 6;
};

void draw_round(Drawn& drawn, const Round& round, const LeafColour& colour) {
  const std::uint32_t middle = drawn.vertex(round.middle, {0, 0, 1}, colour, 1);
  const auto first = middle + 1, count = static_cast<std::uint32_t>(round.corners);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec2 out = direction_of(i / static_cast<double>(round.corners));
    drawn.vertex(at_height(in_plan(round.middle) + out * round.radius, round.rim_z), at_height(out * 0.3, 1), colour,
                 1);
  }
  for (std::uint32_t i = 0; i < count; ++i)
    drawn.mesh.mesh.triangles.push_back({middle, first + i, first + (i + 1) % count});
}

// The shape of the blades of a tuft, as shares of its height.
struct Blades {
  int count = 0;
  double spread = 0, width = 0, lowest = 1, bend = 0;
};

constexpr Blades kMownBlades = {12, 0.9, 0.11, 0.45, 0.75}, kTallBlades = {10, 0.10, 0.02, 0.35, 0.45},
                 kRosette = {6, 0.15, 0.24, 0.25, 0.9}, kStalkLeaves = {5, 0.12, 0.03, 0.2, 0.35};

void draw_blades(Drawn& drawn, const Blades& blades, const RandomSequence& draw, const LeafColour& leaf) {
  for (int i = 0; i < blades.count; ++i) {
    const auto at = static_cast<std::uint32_t>(4 * i);
    const Vec2 out = direction_of(i * 0.381966 + 0.1 * draw.unit(at)), lean = direction_of(draw.unit(at + 1));
    const double height = i == 0 ? 1 : draw.between(blades.lowest, 1, at + 2);
    draw_blade(drawn,
               {out * (blades.spread * std::sqrt((i + 0.5) / blades.count)), unit(out + lean), -kBuried, height,
                blades.bend * height * draw.between(0.4, 1, at + 3), blades.width},
               leaf);
  }
}

void draw_stalk(Drawn& drawn, Vec2 foot, double height, double width, const LeafColour& leaf) {
  draw_blade(drawn, {foot, {1, 0}, -kBuried, height, 0, width}, leaf);
  draw_blade(drawn, {foot, {0, 1}, -kBuried, height, 0, width}, leaf);
}

// Ears on three stalks.
void draw_ears(Drawn& drawn, const RandomSequence& draw, const LeafColour& leaf) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Vec2 lean = direction_of(draw.unit(100 + i)), foot = lean * 0.05;
    const double height = i == 0 ? 1 : draw.between(0.7, 0.95, 110 + i), bend = 0.12 * height;
    draw_blade(drawn, {foot, lean, -kBuried, height, bend, 0.008}, leaf);
    const Vec2 at = foot + lean * (0.55 * bend);
    draw_blade(drawn, {at, lean, 0.74 * height, height, 0.3 * bend, 0.03}, kEar);
    draw_blade(drawn, {at, left_of(lean), 0.74 * height, height, 0, 0.03}, kEar);
  }
}

void draw_clover_leaf(Drawn& drawn, Vec2 at, double z, const LeafColour& leaf) {
  constexpr double kLeaflet = 0.13;
  for (int i = 0; i < 3; ++i) {
    const Vec2 out = direction_of(i / 3.0) * kLeaflet;
    draw_round(drawn, {at_height(at + out, z), kLeaflet, z - 0.02, 5}, leaf);
  }
}

void draw_clover(Drawn& green, Drawn& petals, const RandomSequence& draw, const LeafColour& leaf) {
  for (std::uint32_t i = 0; i < 4; ++i)
    draw_clover_leaf(green, direction_of(0.25 * (i + draw.unit(i))) * 0.45, draw.between(0.4, 0.7, 10 + i), leaf);
  draw_stalk(green, {0, 0}, 0.9, 0.03, leaf);
  draw_round(petals, {{0, 0, 1}, 0.11, 0.88, 6}, kWhitePetal);
  draw_round(petals, {{0, 0, 0.78}, 0.11, 0.88, 6}, kPinkPetal);
}

void draw_daisy(Drawn& green, Drawn& petals, const RandomSequence& draw, const LeafColour& leaf) {
  draw_blades(green, kRosette, draw, leaf);
  draw_stalk(green, {0, 0}, 0.95, 0.03, leaf);
  draw_round(petals, {{0, 0, 0.95}, 0.19, 0.98, 9}, kWhitePetal);
  draw_round(petals, {{0, 0, 1}, 0.075, 0.98, 6}, kYellowPetal);
}

void draw_dandelion(Drawn& green, Drawn& petals, const RandomSequence& draw, const LeafColour& leaf) {
  draw_blades(green, kRosette, draw, leaf);
  draw_stalk(green, {0, 0}, 0.92, 0.04, leaf);
  draw_round(petals, {{0, 0, 1}, 0.19, 0.93, 8}, kYellowPetal);
}

void draw_buttercup(Drawn& green, Drawn& petals, const RandomSequence& draw, const LeafColour& leaf) {
  draw_blades(green, kStalkLeaves, draw, leaf);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Vec2 at = direction_of(draw.unit(100 + i)) * 0.12;
    const double height = i == 0 ? 1 : draw.between(0.7, 0.95, 110 + i);
    draw_stalk(green, at, height - 0.03, 0.01, leaf);
    draw_round(petals, {at_height(at, height - 0.03), 0.035, height, 5}, kYellowPetal);
  }
}

}  // namespace

std::vector<MaterialMesh> tuft_mesh(TuftForm form, std::uint8_t variant, const LeafColour& leaf) {
  const RandomSequence draw(0, StableId{variant}, "tuft mesh");
  Drawn green(Material::kBroadLeaf), petals(Material::kPaint);
  switch (form) {
    case TuftForm::kMown:
      draw_blades(green, kMownBlades, draw, leaf);
      break;
    case TuftForm::kTall:
      draw_blades(green, kTallBlades, draw, leaf);
      draw_ears(green, draw, leaf);
      break;
    case TuftForm::kDaisy:
      draw_daisy(green, petals, draw, leaf);
      break;
    case TuftForm::kDandelion:
      draw_dandelion(green, petals, draw, leaf);
      break;
    case TuftForm::kClover:
      draw_clover(green, petals, draw, leaf);
      break;
    case TuftForm::kButtercup:
    case TuftForm::kCount:
      draw_buttercup(green, petals, draw, leaf);
  }
  if (petals.mesh.mesh.triangles.empty()) return {std::move(green.mesh)};
  return {std::move(green.mesh), std::move(petals.mesh)};
}

}  // namespace citykiln::plants
