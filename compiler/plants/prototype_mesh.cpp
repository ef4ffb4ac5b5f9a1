#include <array>

#include "compiler/plants/expand.h"
#include "compiler/plants/tree_parts.h"

namespace citykiln::plants {
namespace {

using materials::DressedMesh;
using materials::Material;

// The derivation at a detail: 0 is full, 1 and 2 are cut.
using Details = std::array<double, 3>;

// Largest deviation of a cut from the full shape, both ways, for a tree 1 m tall: bounds that prototype_mesh_test.cpp
// proves, rounded up.
constexpr Details kBroadErrors = {0, 0.0615, 0.235}, kNeedleErrors = {0, 0.0615, 0.1};

struct Lump {
  Vec3 centre, radii;
};

// A crown as wide as three fifths of the tree's height, heavier on one side, with a crest.
constexpr Lump kCrown[] = {{{0.00, 0.02, 0.64}, {0.29, 0.28, 0.31}},
                           {{0.15, -0.09, 0.56}, {0.22, 0.21, 0.22}},
                           {{-0.16, 0.04, 0.53}, {0.20, 0.23, 0.20}},
                           {{0.03, 0.06, 0.83}, {0.18, 0.18, 0.17}}};

// All of it in one.
constexpr Lump kWholeCrown = {{0.00, 0.00, 0.64}, {0.36, 0.34, 0.38}};

// Breaks a lump's outline, not its shape.
constexpr double kDent = 0.2;

constexpr Vec3 kHeart = {0, 0, 0.5};

Mesh broad_crown(int detail) {
  Mesh crown;
  if (detail == 2) {
    add_lump(crown, kWholeCrown.centre, kWholeCrown.radii, 0, false, kHeart, 0);
    return crown;
  }
  std::uint32_t number = 0;
  for (const Lump& lump : kCrown) add_lump(crown, lump.centre, lump.radii, kDent, detail == 0, kHeart, number++);
  return crown;
}

// Whorls of branches, narrower and closer towards the tip.
Mesh needle_crown(int detail) {
  constexpr std::array kSkirts = {7, 4, 1}, kSides = {10, 7, 6};
  constexpr double kLowest = 0.14, kWidest = 0.19;
  Mesh crown;
  const int skirts = kSkirts[detail];
  for (int i = 0; i < skirts; ++i) {
    const double place = static_cast<double>(i) / skirts, rim = kLowest + (1 - kLowest) * place;
    // each skirt reaches up into the one after the next, the last to the tip
    const double tip = i + 2 >= skirts ? 1 : kLowest + (1 - kLowest) * (i + 2.0) / skirts;
    add_skirt(crown, kSides[detail], rim, tip, kWidest * (1 - 0.9 * place), static_cast<std::uint32_t>(i));
  }
  return crown;
}

Mesh trunk(bool is_broad, int detail) {
  constexpr std::array kSides = {5, 3, 3};
  Mesh mesh;
  // below z = 0 it reaches into sloping ground
  if (is_broad)
    add_trunk(mesh, kSides[detail], -0.05, 0.5, 0.028, 0.016);
  else
    add_trunk(mesh, kSides[detail], -0.05, 0.3, 0.022, 0.014);
  return mesh;
}

}  // namespace

PrototypeMesh prototype_mesh(Prototype prototype, double height_m, double tolerance_m) {
  if (height_m <= tolerance_m) return {{}, 1};
  const bool is_broad = values_of(prototype.species).leaves != Leaves::kNeedle;
  const Details& errors = is_broad ? kBroadErrors : kNeedleErrors;
  int detail = 2;
  while (errors[detail] * height_m > tolerance_m) --detail;
  PrototypeMesh tree{{}, errors[detail]};
  tree.meshes.push_back({trunk(is_broad, detail), Material::kBark, materials::kNoTint, {}});
  tree.meshes.push_back({is_broad ? broad_crown(detail) : needle_crown(detail),
                         is_broad ? Material::kBroadLeaf : Material::kNeedleLeaf,
                         materials::kNoTint,
                         {}});
  return tree;
}

}  // namespace citykiln::plants
