#include "compiler/plants/prototypes/sprays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/trig.h"
#include "compiler/impostor/impostor.h"

namespace citykiln::plants {
namespace {

using materials::MaterialMesh;

struct Spray {
  std::string_view name;
  int twigs, leaves;
  double length, width, lean, spread;
};

constexpr Spray kSprays[] = {
#define SPRAY(name, twigs, leaves, length, width, lean, spread) {name, twigs, leaves, length, width, lean, spread},
#include "lsystems/species/species.inc"
};

// Brightness of a twig's leaves.
constexpr std::array<std::uint8_t, 3> kShades = {196, 226, 255};

// Width of a twig as a share of the spray's length.
constexpr double kTwig = 0.02;

const Spray* spray_called(std::string_view name) {
  const auto found = std::ranges::find(kSprays, name, &Spray::name);
  return found == std::end(kSprays) ? nullptr : &*found;
}

void add_triangle(Mesh& mesh, Vec2 a, Vec2 b, Vec2 c, double z) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec2 p : {a, b, c}) mesh.positions.push_back(at_height(p, z));
  // counter-clockwise from above, whatever the order given
  const bool is_left = cross(b - a, c - a) > 0;
  mesh.triangles.push_back({first, first + (is_left ? 1 : 2), first + (is_left ? 2 : 1)});
}

// A leaf from stalk to tip, widest below its middle.
void add_leaf(Mesh& mesh, Vec2 stalk, Vec2 along, double width, double z) {
  const Vec2 out = left_of(along) * (width / length(along) / 2);
  const Vec2 tip = stalk + along;
  const Vec2 low = stalk + along * 0.3, high = stalk + along * 0.68;
  add_triangle(mesh, stalk, low + out, low - out, z);
  add_triangle(mesh, low + out, low - out, high + out * 0.75, z);
  add_triangle(mesh, low - out, high + out * 0.75, high - out * 0.75, z);
  add_triangle(mesh, high + out * 0.75, high - out * 0.75, tip, z);
}

struct Shaded {
  std::array<Mesh, kShades.size()> by_shade;
};

// Where a spray of length 1 stands in the picture: its stalk, and its direction and length.
struct SprayPlace {
  Vec2 stalk{0, 0}, along{0, 1};
  Vec2 at(Vec2 p) const { return stalk + turned(p); }
  Vec2 turned(Vec2 p) const { return along * p.y - left_of(along) * p.x; }
};

void add_leaves(Shaded& shaded, const Spray& spray, double leaf_share, const SprayPlace& on,
                const RandomSequence& draw) {
  for (int i = 0; i < spray.leaves; ++i) {
    const auto dice = static_cast<std::uint32_t>(8 * i);
    const bool is_tip = i + 1 == spray.leaves;
    const double place = static_cast<double>(i) / spray.leaves;
    const double side = is_tip ? 0 : i % 2 == 0 ? 1 : -1;
    const double turn = 0.25 + side * spray.lean * draw.between(0.8, 1.25, dice);
    const double size = spray.length * draw.between(0.85, 1.1, dice + 1) * (is_tip ? 1 : 1 - 0.25 * place);
    const Vec2 stalk{0, is_tip ? 1 - size : place * (1 - 0.5 * spray.length)};
    const auto shade = draw.below(kShades.size(), dice + 2);
    const double width = draw.unit(dice + 4) < leaf_share ? spray.width : kTwig;
    add_leaf(shaded.by_shade[shade], on.at(stalk), on.turned(direction_of(turn) * size), width * length(on.along),
             0.01 * draw.unit(dice + 3));
  }
  add_leaf(shaded.by_shade[0], on.stalk, on.turned({0, 1 - 0.6 * spray.length}), kTwig * length(on.along), 0);
}

// The leaves of a spray: of one twig, or of twigs on both sides of a longer one.
void add_spray(Shaded& shaded, const Spray& spray, double leaf_share) {
  constexpr double kTwigLength = 0.46, kTwigLean = 0.12;
  if (spray.twigs == 1) return add_leaves(shaded, spray, leaf_share, {}, RandomSequence(1, StableId{}, "spray"));
  add_leaf(shaded.by_shade[0], {0, 0}, {0, 1 - kTwigLength}, kTwig, 0);
  for (int i = 0; i < spray.twigs; ++i) {
    const RandomSequence draw(1, stable_id(StableId{}, "twig", static_cast<std::uint64_t>(i)), "spray");
    const bool is_tip = i + 1 == spray.twigs;
    const double side = is_tip ? 0 : i % 2 == 0 ? 1 : -1, place = i / (spray.twigs - 1.0);
    const Vec2 out = direction_of(0.25 + side * kTwigLean * draw.between(0.8, 1.3, 90)) * kTwigLength;
    add_leaves(shaded, spray, leaf_share, {{0, place * (1 - kTwigLength)}, {out.x * spray.spread, out.y}}, draw);
  }
}

// Sprays that point away from the middle, evenly over the ellipse in the picture (a sunflower's seeds).
void add_clump(Shaded& shaded, const Spray& spray, double leaf_share) {
  constexpr double kLong = 0.28, kGoldenTurn = 0.381966;
  for (int i = 0; i < kClumpSprays; ++i) {
    const RandomSequence draw(1, stable_id(StableId{}, "clump", static_cast<std::uint64_t>(i)), "spray");
    const Vec2 round = direction_of(kGoldenTurn * i), out{round.x * spray.spread, round.y};
    const double from = 0.5 * std::sqrt((i + 0.5) / kClumpSprays) - 0.75 * kLong;
    add_leaves(shaded, spray, leaf_share, {Vec2{0, 0.5} + out * from, round * kLong}, draw);
  }
}

void add_disc(Shaded& shaded) {
  constexpr int kSides = 16;
  for (int i = 0; i < kSides; ++i)
    add_triangle(shaded.by_shade[1], {0, 0.5}, Vec2{0, 0.5} + direction_of(i / double{kSides}) * 0.5,
                 Vec2{0, 0.5} + direction_of((i + 1) / double{kSides}) * 0.5, 0);
}

void add_unit_card(Shaded& shaded) {
  add_triangle(shaded.by_shade[2], {-0.5, 0}, {0.5, 0}, {0.5, 1}, 0);
  add_triangle(shaded.by_shade[2], {-0.5, 0}, {0.5, 1}, {-0.5, 1}, 0);
}

}  // namespace

double width_of_spray(std::string_view name) {
  const Spray* spray = spray_called(name);
  return spray == nullptr ? 1 : spray->spread;
}

bool is_fruit(std::string_view name) { return !name.empty() && spray_called(name) == nullptr; }

impostor::Picture picture_of_spray(std::string_view name, materials::Material material, double leaf_share,
                                   bool is_clump) {
  assert(0 <= leaf_share && leaf_share <= 1);
  Shaded shaded;
  const Spray* spray = spray_called(name);
  if (spray != nullptr && is_clump) add_clump(shaded, *spray, leaf_share);
  if (spray != nullptr && !is_clump) add_spray(shaded, *spray, leaf_share);
  if (spray == nullptr) name.empty() ? add_unit_card(shaded) : add_disc(shaded);
  std::vector<MaterialMesh> meshes;
  for (std::size_t s = 0; s < kShades.size(); ++s)
    meshes.push_back({std::move(shaded.by_shade[s]), material, {kShades[s], kShades[s], kShades[s], 255}, {}});
  const double width = width_of_spray(name);
  impostor::View view{{-width / 2, 1, 0.5}, {1, 0, 0}, {0, -1, 0}, kSprayTexel, kSprayTexels, kSprayTexels, 1, 1};
  view.columns = static_cast<std::uint32_t>(width * kSprayTexels + 0.5);
  // opaque blades need few texels
  if (name.empty()) view.texel_m = 0.25, view.columns = view.rows = 4;
  return impostor::render(impostor::model_of(meshes), view).picture;
}

}  // namespace citykiln::plants
