#include "compiler/plants/prototype_mesh.h"

#include <algorithm>
#include <cmath>

#include "compiler/plants/crossed_cards.h"
#include "compiler/plants/crown_hull.h"
#include "compiler/plants/leaf_clusters.h"
#include "compiler/plants/looks.h"
#include "compiler/plants/sprays.h"
#include "lsystems/tubes.h"

namespace citykiln::plants {
namespace {

using materials::DressedMesh;
using materials::Material;

// A spray covers so much of its card: pictures from afar are made of cards that are as much smaller.
constexpr double kSprayCover = 0.42;

// A plant without its trunk would hang in the air: stems so much thinner than the thickest one stay.
constexpr double kTrunkStays = 0.6;

void scale(PrototypeMesh& plant, double by) {
  for (DressedMesh& dressed : plant.meshes)
    for (Vec3& p : dressed.mesh.positions) p = p * by;
  plant.error_per_m *= by;
}

double thickest_m(const lsystems::Skeleton& skeleton) {
  double thickest = 0;
  for (const lsystems::Segment& segment : skeleton.segments) thickest = std::max(thickest, 2 * segment.start_radius);
  return thickest;
}

DressedMesh bark_of(const Grown& grown, const Look& look, double tolerance_m, double& error_m) {
  lsystems::TubeOptions options;
  options.tolerance_m = std::min(tolerance_m, kTrunkStays * thickest_m(grown.skeleton)), options.instances = false;
  lsystems::Skeleton stems;
  stems.segments = grown.skeleton.segments;
  lsystems::PlantMesh mesh = lsystems::mesh_plant(stems, options);
  error_m = std::max(error_m, mesh.error_m);
  DressedMesh bark{{std::move(mesh.bark.positions), std::move(mesh.bark.normals), std::move(mesh.bark.triangles)},
                   Material::kBark,
                   look.bark,
                   {}};
  return bark;
}

// Sprays on a sheet of texels of size 1, whatever a card's size is.
struct SprayedLeaves {
  DressedMesh mesh;
  imprint::CutoutLayout layout;
  std::vector<Vec2> size_m;
};

SprayedLeaves sprays_of(const Foliage& foliage, Material material) {
  SprayedLeaves leaves;
  std::vector<imprint::Picture> pictures;
  for (const std::string& name : foliage.sprays) {
    pictures.push_back(picture_of_spray(name, material));
    leaves.size_m.push_back(Vec2{double(pictures.back().columns), double(pictures.back().rows)} * kSprayTexel);
  }
  leaves.layout = imprint::cut_out(std::move(pictures), kSprayTexel);
  leaves.mesh.material = material, leaves.mesh.coloured = materials::Coloured::kByCutout;
  return leaves;
}

void add_card(SprayedLeaves& leaves, const Card& card) {
  Mesh& mesh = leaves.mesh.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Vec2 at = leaves.layout.at_m[card.spray], size = leaves.size_m[card.spray];
  const auto corners = corners_of(card);
  const Vec2 uvs[] = {{0, 0}, {0, size.y}, size, {size.x, 0}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    mesh.positions.push_back(corners[i]), mesh.normals.push_back(card.normal);
    leaves.mesh.uvs.push_back(at + uvs[i]), leaves.mesh.tints.push_back(card.tint);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

PrototypeMesh near_mesh(const Grown& grown, Species species, double tolerance_m) {
  const Look look = look_of(species);
  PrototypeMesh plant;
  if (!grown.skeleton.segments.empty()) plant.meshes.push_back(bark_of(grown, look, tolerance_m, plant.error_per_m));
  if (grown.foliage.cards.empty()) return plant;
  const Clusters clusters = cluster(grown.foliage, tolerance_m);
  plant.error_per_m = std::max(plant.error_per_m, clusters.error_m);
  SprayedLeaves leaves = sprays_of(grown.foliage, look.leaf_material);
  for (const Card& card : clusters.cards) add_card(leaves, card);
  plant.meshes.push_back(std::move(leaves.mesh));
  plant.cutout = std::move(leaves.layout.cutout);
  return plant;
}

// A kite of the card's leaves' area, from both sides.
void add_kite(Mesh& mesh, const Card& card, double cover) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const double share = std::sqrt(cover);
  const Vec3 c = card.centre(), a = card.across * (share / 2), b = card.along * (share / 2);
  for (const Vec3 p : {c - a - b, c - a + b, c + a + b, c + a - b}) mesh.positions.push_back(p);
  for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}})
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// What pictures are taken of: leaves by their tints, which are few.
std::vector<DressedMesh> sitter_of(const Grown& grown, const Look& look, double tolerance_m) {
  double ignored = 0;
  std::vector<DressedMesh> meshes{bark_of(grown, look, tolerance_m, ignored)};
  for (const Card& card : grown.foliage.cards) {
    auto same = std::find_if(meshes.begin() + 1, meshes.end(), [&](const auto& m) { return m.tint == card.tint; });
    if (same == meshes.end()) same = meshes.insert(same, DressedMesh{{}, look.leaf_material, card.tint, {}});
    add_kite(same->mesh, card, grown.foliage.sprays[card.spray].empty() ? 1 : kSprayCover);
  }
  return meshes;
}

PrototypeMesh far_mesh(const Grown& grown, Species species, double tolerance_m) {
  const Look look = look_of(species);
  CrossedCards cards = crossed_cards(sitter_of(grown, look, tolerance_m / 16), tolerance_m);
  cards.mesh.material = look.leaf_material;
  PrototypeMesh plant{{}, std::move(cards.cutout), cards.error_m};
  plant.meshes.push_back(std::move(cards.mesh));
  return plant;
}

PrototypeMesh farthest_mesh(const Grown& grown, Species species) {
  const Look look = look_of(species);
  CrownHull hull = crown_hull(grown.foliage);
  PrototypeMesh plant{{}, {}, hull.error_m};
  plant.meshes.push_back({std::move(hull.mesh), look.leaf_material, look.leaf, {}});
  return plant;
}

}  // namespace

PrototypeMesh prototype_mesh(const Grown& grown, Species species, double height_m, double tolerance_m) {
  const double share = tolerance_m / height_m;
  if (share >= 1 || !(grown.height_m > 0)) return {{}, {}, 1};
  const double own_m = share * grown.height_m;
  PrototypeMesh plant = share < kCardsFrom  ? near_mesh(grown, species, own_m)
                        : share < kBodyFrom ? far_mesh(grown, species, own_m)
                                            : farthest_mesh(grown, species);
  scale(plant, 1 / grown.height_m);
  return plant;
}

int variants_at(double tolerance_m) { return tolerance_m < 0.05 ? 2 : tolerance_m < 1 ? 4 : kVariants; }

}  // namespace citykiln::plants
