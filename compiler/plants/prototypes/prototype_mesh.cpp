#include "compiler/plants/prototypes/prototype_mesh.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/materials/texture.h"
#include "compiler/plants/prototypes/crossed_cards.h"
#include "compiler/plants/prototypes/crown_hull.h"
#include "compiler/plants/prototypes/leaf_clusters.h"
#include "compiler/plants/prototypes/sprays.h"
#include "compiler/plants/prototypes/stems.h"

namespace citykiln::plants {
namespace {

using materials::Material;
using materials::MaterialMesh;

// Share of a card that its spray covers: pictures for crossed cards are taken of cards reduced to it.
constexpr double kSprayCover = 0.42, kTwigsCover = 0.1;

// Brightness of crossed cards, hulls and boxes, which do not shadow themselves: the factors that make woods as bright
// as those of leaves in `chart plant`. Twigs shadow less.
constexpr double kCardShade = 0.52, kHullShade = 0.25, kBoxShade = 0.6, kTwigsCardShade = 0.8, kTwigsHullShade = 0.42;

void scale(PrototypeMesh& plant, double by) {
  for (MaterialMesh& dressed : plant.meshes)
    for (Vec3& p : dressed.mesh.positions) p = p * by;
  plant.error_per_m *= by;
}

materials::Tint shaded(materials::Tint tint, double share) {
  for (std::size_t c = 0; c < 3; ++c) tint[c] = static_cast<std::uint8_t>(tint[c] * share + 0.5);
  return tint;
}

// Rounded to the grid of texture coordinates, which 16 bits can store.
Vec2 on_grid(Vec2 uv) {
  const auto nearest = [](double v) {
    return std::floor(v / materials::kTextureCoordinateStep_m + 0.5) * materials::kTextureCoordinateStep_m;
  };
  return {nearest(uv.x), nearest(uv.y)};
}

// Stems with texture coordinates if the material has a texture.
MaterialMesh bark_of(const GrownPlant& grown, Material material, double tolerance_m, double& error_m) {
  StemMesh stems = mesh_stems(grown.skeleton, tolerance_m, materials::texture_side_m(material));
  error_m = std::max(error_m, stems.error_m);
  for (Vec2& uv : stems.uvs) uv = on_grid(uv);
  return {std::move(stems.mesh), material, grown.appearance.bark, {}, std::move(stems.uvs)};
}

// Leaf cards and the atlas of their sprays; coordinates are in units of a spray, whatever the card's size.
struct SprayedLeaves {
  MaterialMesh mesh;
  impostor::CutoutLayout layout;
  std::vector<Vec2> size_m;
};

SprayedLeaves sprays_of(const Foliage& foliage, const Appearance& appearance) {
  SprayedLeaves leaves;
  std::vector<impostor::Picture> pictures;
  for (const std::string& name : foliage.sprays) {
    pictures.push_back(picture_of_spray(name, appearance.leaf_material, appearance.leaf_share));
    leaves.size_m.push_back(Vec2{double(pictures.back().columns), double(pictures.back().rows)} * kSprayTexel);
  }
  leaves.layout = impostor::lay_out_cutout(std::move(pictures), kSprayTexel);
  leaves.mesh.material = appearance.leaf_material, leaves.mesh.colour_source = materials::ColourSource::kByCutout;
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

// Tubes and leaf cards.
// @param tolerance_m  In units of the grown plant.
PrototypeMesh detailed_mesh(const GrownPlant& grown, Material bark, double tolerance_m) {
  PrototypeMesh plant;
  if (!grown.skeleton.segments.empty()) plant.meshes.push_back(bark_of(grown, bark, tolerance_m, plant.error_per_m));
  if (grown.foliage.cards.empty()) return plant;
  const Clusters clusters = cluster(grown.foliage, tolerance_m);
  plant.error_per_m = std::max(plant.error_per_m, clusters.error_m);
  SprayedLeaves leaves = sprays_of(grown.foliage, grown.appearance);
  for (const Card& card : clusters.cards) add_card(leaves, card);
  plant.meshes.push_back(std::move(leaves.mesh));
  plant.cutout = std::move(leaves.layout.cutout);
  return plant;
}

// A two-sided rectangle of the area that the card's leaves cover.
void add_leaf_area(Mesh& mesh, const Card& card, double cover) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const double share = std::sqrt(cover);
  const Vec3 c = card.centre(), a = card.across * (share / 2), b = card.along * (share / 2);
  for (const Vec3 p : {c - a - b, c - a + b, c + a + b, c + a - b}) mesh.positions.push_back(p);
  for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}})
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// The shape that crossed cards picture: bark, and one mesh for each leaf tint.
std::vector<MaterialMesh> impostor_source(const GrownPlant& grown, double tolerance_m) {
  const Appearance& appearance = grown.appearance;
  const double cover = std::lerp(kTwigsCover, kSprayCover, appearance.leaf_share);
  double ignored = 0;
  std::vector<MaterialMesh> meshes{bark_of(grown, Material::kBark, tolerance_m, ignored)};
  for (const Card& card : grown.foliage.cards) {
    auto same = std::find_if(meshes.begin() + 1, meshes.end(), [&](const auto& m) { return m.tint == card.tint; });
    if (same == meshes.end()) same = meshes.insert(same, MaterialMesh{{}, appearance.leaf_material, card.tint, {}});
    add_leaf_area(same->mesh, card, grown.foliage.sprays[card.spray].empty() ? 1 : cover);
  }
  return meshes;
}

PrototypeMesh crossed_mesh(const GrownPlant& grown, double tolerance_m) {
  CrossedCards cards = crossed_cards(impostor_source(grown, tolerance_m / 16), tolerance_m);
  cards.mesh.material = grown.appearance.leaf_material;
  cards.mesh.tint = shaded(materials::kNoTint, std::lerp(kTwigsCardShade, kCardShade, grown.appearance.leaf_share));
  PrototypeMesh plant{{}, std::move(cards.cutout), cards.error_m};
  plant.meshes.push_back(std::move(cards.mesh));
  return plant;
}

bool is_hedge(Species species) { return species == Species::kHedge; }

PrototypeMesh hull_mesh(const GrownPlant& grown, Species species) {
  const Appearance& appearance = grown.appearance;
  const double shade = is_hedge(species) ? kBoxShade : std::lerp(kTwigsHullShade, kHullShade, appearance.leaf_share);
  CrownHull hull = is_hedge(species) ? crown_box(grown.foliage) : crown_hull(grown.foliage);
  PrototypeMesh plant{{}, {}, hull.error_m};
  plant.meshes.push_back({std::move(hull.mesh), appearance.leaf_material, shaded(appearance.leaf, shade), {}});
  return plant;
}

}  // namespace

PrototypeMesh prototype_mesh(const GrownPlant& grown, Species species, double height_m, double tolerance_m) {
  assert(height_m > 0 && tolerance_m > 0);
  const double height_share = grown.appearance.height_share, share = tolerance_m / (height_m * height_share);
  if (!(share < 1) || !(grown.height_m > 0)) return {{}, {}, height_share};
  const double own_m = share * grown.height_m;
  const double cards_from = is_hedge(species) ? kBoxFrom : kCardsFrom;
  const double hull_from = is_hedge(species) ? kBoxFrom : kHullFrom;
  const Material bark = has_texture(grown.bark, tolerance_m) ? grown.bark : Material::kBark;
  PrototypeMesh plant = share < cards_from  ? detailed_mesh(grown, bark, own_m)
                        : share < hull_from ? crossed_mesh(grown, own_m)
                                            : hull_mesh(grown, species);
  scale(plant, height_share / grown.height_m);
  return plant;
}

int variants_at(double tolerance_m) { return has_detail(Detail::kAllPlantVariants, tolerance_m) ? kVariants : 2; }

}  // namespace citykiln::plants
