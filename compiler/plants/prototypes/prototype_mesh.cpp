#include "compiler/plants/prototypes/prototype_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/materials/texture.h"
#include "compiler/plants/prototypes/crown_hull.h"
#include "compiler/plants/prototypes/leaf_clusters.h"
#include "compiler/plants/prototypes/leaf_outlines.h"
#include "compiler/plants/prototypes/stems.h"

namespace citykiln::plants {
namespace {

using materials::Material;
using materials::MaterialMesh;

// Brightness of hulls and boxes, which do not shadow themselves: the factors that make woods as bright as those of
// leaves in `citykiln-chart plant`. Twigs shadow less.
constexpr double kHullShade = 0.25, kBoxShade = 0.6, kTwigsHullShade = 0.42;

void scale(PrototypeMesh& plant, double by) {
  for (MaterialMesh& dressed : plant.meshes)
    for (Vec3& p : dressed.mesh.positions) p = p * by;
  plant.error_per_m *= by;
}

materials::Tint darkened(materials::Tint tint, double share) {
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

void add_leaf_card(MaterialMesh& leaves, const Card& card, const LeafPlace& part) {
  Mesh& mesh = leaves.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto corners = corners_of(card);
  const Vec2 size = part.size_m, uvs[] = {{0, 0}, {0, size.y}, size, {size.x, 0}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    mesh.positions.push_back(corners[i]), mesh.normals.push_back(card.normal);
    leaves.uvs.push_back(part.at_m + uvs[i]), leaves.tints.push_back(card.tint);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

// Leaf cards with coordinates on the atlas.
MaterialMesh leaves_of(const std::vector<Card>& cards, const GrownPlant& grown, const LeafAtlas& atlas) {
  std::map<std::pair<std::uint8_t, bool>, LeafPlace> places;
  MaterialMesh leaves;
  leaves.material = grown.appearance.leaf_material, leaves.colour_source = materials::ColourSource::kByCutout;
  for (const Card& card : cards) {
    const auto [place, is_new] = places.try_emplace({card.spray, card.is_clump});
    if (is_new) place->second = place_of(atlas, grown.foliage.sprays[card.spray], card.is_clump, grown.appearance);
    add_leaf_card(leaves, card, place->second);
  }
  return leaves;
}

// Outlines are simplified by less than this share of a leaf's width, so that both of its sides remain.
constexpr double kSideShare = 0.3;

// Adds the leaves that have an outline, in the plain colour of blades.
void add_outlines(MaterialMesh& leaves, const GrownPlant& grown, const LeafAtlas& atlas, double bend_m) {
  for (const Card& card : grown.foliage.cards) {
    if (card.outline == kNoOutline) continue;
    const auto& corners = grown.foliage.outlines[static_cast<std::size_t>(card.outline)];
    const LeafPlace place = place_of(atlas, grown.foliage.sprays[card.spray], false, grown.appearance);
    const double keeps_sides_m = kSideShare * length(card.across);
    const Mesh leaf =
        outline_mesh(simplified_outline(corners, std::min(bend_m, keeps_sides_m)), cross(card.along, card.across));
    const auto first = static_cast<std::uint32_t>(leaves.mesh.positions.size());
    for (const Vec3 p : leaf.positions) {
      leaves.mesh.positions.push_back(p), leaves.mesh.normals.push_back(card.normal);
      leaves.uvs.push_back(on_grid(place.at_m + place.size_m * 0.5)), leaves.tints.push_back(card.tint);
    }
    for (const Triangle& t : leaf.triangles)
      leaves.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

// The cards of leaves without an outline.
Foliage without_outlines(const Foliage& foliage) {
  Foliage cards = foliage;
  std::erase_if(cards.cards, [](const Card& card) { return card.outline != kNoOutline; });
  return cards;
}

// True if all leaves of a plant have an outline.
bool has_outlines_only(const Foliage& foliage) {
  return !foliage.cards.empty() &&
         std::ranges::all_of(foliage.cards, [](const Card& card) { return card.outline != kNoOutline; });
}

// The share of the tolerance by which outlines are simplified.
constexpr double kOutlineBend = 0.5;

// Width of leaf clusters in tolerances; finer than at kEvenShare of the height they grow only with the tolerance's
// root, since a plant has no more leaves to lose: so triangles fall evenly from level to level. The picture error of
// `citykiln-chart plant` stays that of the noise there.
constexpr double kClusterWidth = 2.8, kWidestCluster = 6, kEvenShare = 1.0 / 64;

double cluster_width(double share) {
  return share * std::min(kClusterWidth * std::sqrt(std::max(1.0, kEvenShare / share)), kWidestCluster);
}

// Clusters of the leaves without an outline, and the leaves with one.
MaterialMesh leaves_with_outlines(const GrownPlant& grown, const LeafAtlas& atlas, double share, double& error_m) {
  const double bend_m = kOutlineBend * share * grown.height_m;
  const Clusters clusters = cluster(without_outlines(grown.foliage), cluster_width(share) * grown.height_m);
  MaterialMesh leaves = leaves_of(clusters.cards, grown, atlas);
  add_outlines(leaves, grown, atlas, bend_m);
  error_m = std::max({error_m, clusters.error_m, bend_m});
  return leaves;
}

// Tubes and leaf cards.
// @param share  The tolerance over the height.
PrototypeMesh detailed_mesh(const GrownPlant& grown, const LeafAtlas& atlas, Material bark, double share) {
  const double tolerance_m = share * grown.height_m;
  PrototypeMesh plant;
  if (!grown.skeleton.segments.empty()) plant.meshes.push_back(bark_of(grown, bark, tolerance_m, plant.error_per_m));
  if (grown.foliage.cards.empty()) return plant;
  if (grown.foliage.outlines.empty()) {
    const Clusters clusters = cluster(grown.foliage, cluster_width(share) * grown.height_m);
    plant.error_per_m = std::max(plant.error_per_m, clusters.error_m);
    plant.meshes.push_back(leaves_of(clusters.cards, grown, atlas));
  } else {
    plant.meshes.push_back(leaves_with_outlines(grown, atlas, share, plant.error_per_m));
  }
  plant.shows_leaf_atlas = true;
  return plant;
}

bool is_hedge(Species species) { return species == Species::kHedge; }

// A small card at the end of each segment: the crown of a plant without leaves.
Foliage ends_of_stems(const GrownPlant& grown) {
  constexpr double kSize = 1e-3;
  Foliage ends;
  for (const lsystems::Segment& segment : grown.skeleton.segments) {
    const lsystems::TurtleFrame end = segment.end();
    const double size_m = kSize * grown.height_m;
    ends.cards.push_back(
        {.corner = end.at, .across = end.left * size_m, .along = end.heading * size_m, .normal = end.up});
  }
  return ends;
}

// The hull of the stems, as light as one of twigs.
PrototypeMesh leafless_hull_mesh(const GrownPlant& grown) {
  CrownHull hull = crown_hull(ends_of_stems(grown));
  PrototypeMesh plant{{}, false, hull.error_m};
  plant.meshes.push_back({std::move(hull.mesh), Material::kBark, darkened(grown.appearance.bark, kTwigsHullShade), {}});
  return plant;
}

PrototypeMesh hull_mesh(const GrownPlant& grown, Species species) {
  if (grown.foliage.cards.empty()) return leafless_hull_mesh(grown);
  const Appearance& appearance = grown.appearance;
  const double shade = is_hedge(species) ? kBoxShade : std::lerp(kTwigsHullShade, kHullShade, appearance.leaf_share);
  CrownHull hull = is_hedge(species) ? crown_box(grown.foliage) : crown_hull(grown.foliage);
  PrototypeMesh plant{{}, false, hull.error_m};
  plant.meshes.push_back({std::move(hull.mesh), appearance.leaf_material, darkened(appearance.leaf, shade), {}});
  return plant;
}

}  // namespace

PrototypeMesh prototype_mesh(const GrownPlant& grown, const LeafAtlas& atlas, Species species, double height_m,
                             double tolerance_m) {
  assert(height_m > 0 && tolerance_m > 0);
  const double height_share = grown.appearance.height_share, share = tolerance_m / (height_m * height_share);
  if (!(share < 1) || !(grown.height_m > 0)) return {{}, false, height_share};
  const double hull_from = is_hedge(species) ? kBoxFrom : kHullFrom;
  const Material bark = has_texture(grown.bark, tolerance_m) ? grown.bark : Material::kBark;
  const bool is_detailed = share < hull_from || has_outlines_only(grown.foliage);
  PrototypeMesh plant = is_detailed ? detailed_mesh(grown, atlas, bark, share) : hull_mesh(grown, species);
  scale(plant, height_share / grown.height_m);
  return plant;
}

int variants_at(double tolerance_m) { return has_detail(Detail::kAllPlantVariants, tolerance_m) ? kVariants : 2; }

}  // namespace citykiln::plants
