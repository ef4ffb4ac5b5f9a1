#include "compiler/plants/prototypes/canopy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/snap.h"
#include "compiler/materials/material.h"
#include "compiler/plants/appearance.h"
#include "compiler/plants/placing/wood_index.h"

namespace citykiln::plants {
namespace {

using materials::Material;
using materials::MaterialMesh;

// The mean height and colour of a wood at a position, as seen from above. The canopy (canopy.h), one surface that
// replaces the trees of a dense wood at coarse levels, takes the heights and colours of its vertices from here.

// The wood at a position.
struct CrownAverage {
  double height_m = 0;  ///< Mean height of the sampled trees; 0: no wood within 6 m.
  /// Uniform random number in [0, 1) that depends on the position only. It varies the canopy's height.
  double uniform = 0;
  /// Linear reflectance (red, green, blue) of crowns and of the ground that shows between them.
  std::array<double, 3> colour{};
  std::uint32_t wood =
      ground::kNoLandCover;  ///< Index of the wood in WoodIndex::woods; kNoLandCover: no wood within 6 m.
};

using Colour = std::array<double, 3>;

// About the number of trees in a cell of the canopy.
constexpr int kTrees = 3;

// A wood this near counts, so that paths have the canopy of their wood.
constexpr double kBeside_m = 6;

// Brightness of closed crowns and of the ground below them, as shares of the reflectance of a leaf and the ground:
// crowns shadow each other and the ground. Bare twigs shadow less. Measured as in prototype_mesh.cpp.
constexpr double kCrownShade = 0.15, kTwigsShade = 0.4, kGroundShade = 0.57;

// Tint of ground with fallen leaves.
constexpr Colour kLitter = {1, 0.73, 0.86};

// Random brightness: gaps between crowns are darker than treetops.
constexpr double kDarkest = 0.7, kLightest = 1.1;

// Tint of light transmitted by leaves.
constexpr Colour kThrough = {1, 1.1, 1.03};

std::uint32_t wood_near(const WoodIndex& woods, Vec2 p) {
  for (const Vec2 off : {Vec2{}, Vec2{kBeside_m, 0}, Vec2{0, kBeside_m}, Vec2{-kBeside_m, 0}, Vec2{0, -kBeside_m}})
    if (const std::uint32_t wood = wood_at(woods, p + off); wood != ground::kNoLandCover) return wood;
  return ground::kNoLandCover;
}

Colour colour_of(const Appearance& appearance) {
  const double shade = std::lerp(kTwigsShade, kCrownShade, appearance.leaf_share);
  const auto& base = values_of(appearance.leaf_material).base_colour;
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) colour[c] = shade * appearance.leaf[c] / 255 * static_cast<double>(base[c]);
  return colour;
}

// Share of the ground that randomly placed trees of this size hide from above.
double hidden_share(const Wood& wood, const SpeciesValues& species, double height_m, double leaf_share) {
  constexpr double kHectare_m2 = 10000, kQuarterPi = 0.78539816339745, kTwigs = 0.5;
  const double wide_m = species.crown_share * height_m;
  const double layers = kQuarterPi * wide_m * wide_m * wood.trees_per_ha / kHectare_m2;
  return std::lerp(kTwigs, 1.0, leaf_share) * layers / (1 + layers);
}

void add_tree(CrownAverage& mix, const Wood& wood, const Habitat& habitat, const PlacingContext& context,
              const RandomSequence& draw, Month month, const Colour& ground) {
  const SpeciesValues& species =
      context.species[draw_species(context.species, wood.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw))];
  const auto variant = static_cast<std::uint8_t>(draw.unit(kVariantDraw) * kVariants);
  const double height_m = height_in_wood_m(wood, species, habitat, draw);
  const Appearance appearance = appearance_of(species, variant, month);
  const double hidden = hidden_share(wood, species, height_m, appearance.leaf_share);
  const Colour leaves = colour_of(appearance);
  mix.height_m += height_m / kTrees;
  const double seen = kGroundShade * (1 - hidden) * (1 - hidden);
  for (std::size_t c = 0; c < 3; ++c) {
    const double below = ground[c] * std::lerp(kLitter[c], 1.0, appearance.leaf_share);
    mix.colour[c] += kThrough[c] * (hidden * leaves[c] + seen * below) / kTrees;
  }
}

Colour ground_of(const WoodIndex& woods, const Wood& wood) {
  const auto surface =
      std::ranges::lower_bound(woods.context.surfaces.surfaces, wood.surface, {}, &ground::LandCoverPolygon::id);
  const auto& base = values_of(map::values_of(surface->surface).material).base_colour;
  return {base[0], base[1], base[2]};
}

StableId id_of_place(Vec2 p) {
  const auto whole = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v))); };
  return stable_id(StableId{whole(p.x) << 32 ^ (whole(p.y) & 0xffffffffu)}, "canopy", 0);
}

// Returns the mean of three trees of the wood at `p` or within 6 m of it. Species and heights of the three are drawn
// from a hash of the coordinates; they are not the trees that are placed there. The result depends on the position and
// on land cover within 6 m only, so neighbouring tiles agree.
// @param p      Plane metres.
// @param month  The month decides leaves and their colours.
CrownAverage crown_average_at(const WoodIndex& woods, Vec2 p, Month month) {
  CrownAverage mix;
  mix.wood = wood_near(woods, p);
  if (mix.wood == ground::kNoLandCover) return mix;
  const PlacingContext& context = woods.context;
  const Wood& wood = woods.woods[mix.wood];
  const map::Heightfield& terrain = context.ground.terrain;
  const Habitat habitat = habitat_at(climate_mix_at(context.climate, p), context.latitude_deg, p,
                                     height_m_at(terrain, p), normal_at(terrain, p), false);
  const Colour ground = ground_of(woods, wood);
  const RandomSequence draw(context.seed, id_of_place(p), "canopy");
  mix.uniform = draw.unit(0);
  for (std::uint32_t i = 0; i < kTrees; ++i)
    add_tree(mix, wood, habitat, context, RandomSequence(context.seed, stable_id(id_of_place(p), "tree", i), "canopy"),
             month, ground);
  const double light = draw.between(kDarkest, kLightest, 1);
  for (double& c : mix.colour) c *= light;
  return mix;
}

// Samples of a cell each way, and how many of them may lie outside dense woods: a path.
constexpr int kSamplesPerSide = 4, kMostOthers = 4;

// Densities of closed woods have at least this share.
constexpr double kClosedShare = 0.7;

// Least height of trees as a share of the tolerance; lower ones are part of the ground's texture.
constexpr double kLeastHeight = 0.4;

// Range of vertices' heights as shares of the trees' height: gaps between crowns, and treetops.
constexpr double kLowest = 0.5, kHighest = 1;

// Depth of vertices that are not raised below the ground.
constexpr double kRimDepth_m = 1;

// The cells of the box and of one row and column around it, and their vertices.
struct Lattice {
  const WoodIndex& woods;
  const Box2& box;
  double tolerance_m;
  int columns, rows;  // of cells in the box
  std::vector<CrownAverage> crowns{};
  std::vector<bool> closed{};

  Vec2 at(int column, int row) const { return box.min + Vec2{double(column), double(row)} * kCanopyCell_m; }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * (columns + 2) + static_cast<std::size_t>(column + 1);
  }
  std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * (columns + 3) + static_cast<std::size_t>(column + 1);
  }
  bool is_closed(int column, int row) const { return closed[cell(column, row)]; }
  const CrownAverage& mix(int column, int row) const { return crowns[corner(column, row)]; }
};

bool is_closed_cell(const Lattice& lattice, const CorridorIndex& corridors, int column, int row) {
  for (const int c : {column, column + 1})
    for (const int r : {row, row + 1})
      if (lattice.mix(c, r).height_m < kLeastHeight * lattice.tolerance_m) return false;
  int others = 0;
  for (int i = 0; i < kSamplesPerSide * kSamplesPerSide; ++i) {
    const Vec2 share{(i % kSamplesPerSide + 0.5) / kSamplesPerSide, (i / kSamplesPerSide + 0.5) / kSamplesPerSide};
    const Vec2 p = lattice.at(column, row) + share * kCanopyCell_m;
    if (is_in_corridor(corridors, p)) return false;
    const SampleDensity density = density_at(lattice.woods, p);
    if (density.share >= kClosedShare && density.spacing_m > 0 && density.normal_z >= kLeastNormal_z) continue;
    if (++others > kMostOthers || is_blocked_ground(lattice.woods.context.surfaces, p)) return false;
  }
  return true;
}

Lattice lattice_of(const WoodIndex& woods, const CorridorIndex& corridors, const Box2& box, double tolerance_m,
                   Month month) {
  const auto cells = [](double side_m) { return static_cast<int>(side_m / kCanopyCell_m); };
  Lattice lattice{woods, box, tolerance_m, cells(box.width()), cells(box.height())};
  for (int row = -1; row <= lattice.rows + 1; ++row)
    for (int column = -1; column <= lattice.columns + 1; ++column)
      lattice.crowns.push_back(crown_average_at(woods, lattice.at(column, row), month));
  for (int row = -1; row <= lattice.rows; ++row)
    for (int column = -1; column <= lattice.columns; ++column)
      lattice.closed.push_back(is_closed_cell(lattice, corridors, column, row));
  return lattice;
}

// @param column, row  Of a vertex in the box.
bool is_raised(const Lattice& lattice, int column, int row) {
  return lattice.is_closed(column, row) && lattice.is_closed(column - 1, row) && lattice.is_closed(column, row - 1) &&
         lattice.is_closed(column - 1, row - 1);
}

// The number of raised vertices of a cell.
int raised_corners(const Lattice& lattice, int column, int row) {
  return is_raised(lattice, column, row) + is_raised(lattice, column + 1, row) + is_raised(lattice, column, row + 1) +
         is_raised(lattice, column + 1, row + 1);
}

// Height of a raised vertex above the ground.
double canopy_height_m(const CrownAverage& mix) { return mix.height_m * std::lerp(kLowest, kHighest, mix.uniform); }

// From the slopes of terrain and crowns.
Vec3 normal_of(const Lattice& lattice, int column, int row) {
  const Vec3 land = normal_at(lattice.woods.context.ground.terrain, lattice.at(column, row));
  const double own_m = canopy_height_m(lattice.mix(column, row));
  const auto height_m = [&](int c, int r) {
    const CrownAverage& mix = lattice.mix(c, r);
    return mix.wood == ground::kNoLandCover ? own_m : canopy_height_m(mix);
  };
  constexpr double kAcross = 1 / (2 * kCanopyCell_m);
  return unit(Vec3{land.x / land.z - (height_m(column + 1, row) - height_m(column - 1, row)) * kAcross,
                   land.y / land.z - (height_m(column, row + 1) - height_m(column, row - 1)) * kAcross, 1});
}

Vec3 place_of_vertex(const Lattice& lattice, int column, int row) {
  const Vec2 p = lattice.at(column, row);
  const double land = land_m(lattice.woods.context.ground, p);
  const bool is_up = is_raised(lattice, column, row);
  return snapped(at_height(p, is_up ? land + canopy_height_m(lattice.mix(column, row)) : land - kRimDepth_m));
}

materials::Tint canopy_tint(const CrownAverage& mix) {
  const auto& base = values_of(Material::kBroadLeaf).base_colour;
  materials::Tint tint = materials::kNoTint;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] =
        static_cast<std::uint8_t>(std::clamp(mix.colour[c] / static_cast<double>(base[c]) * 255, 0.0, 255.0) + 0.5);
  return tint;
}

// The canopy of one wood.
struct Part {
  MaterialMesh dressed{};
  std::map<std::size_t, std::uint32_t> vertices{};  // by Lattice::corner()

  std::uint32_t vertex(const Lattice& lattice, int column, int row) {
    const auto next = static_cast<std::uint32_t>(dressed.mesh.positions.size());
    const auto [at, is_new] = vertices.try_emplace(lattice.corner(column, row), next);
    if (!is_new) return at->second;
    dressed.mesh.positions.push_back(place_of_vertex(lattice, column, row));
    dressed.mesh.normals.push_back(normal_of(lattice, column, row));
    dressed.tints.push_back(canopy_tint(lattice.mix(column, row)));
    return next;
  }
};

void add_cell(Part& part, const Lattice& lattice, int column, int row) {
  const std::uint32_t a = part.vertex(lattice, column, row), b = part.vertex(lattice, column + 1, row),
                      c = part.vertex(lattice, column + 1, row + 1), d = part.vertex(lattice, column, row + 1);
  part.dressed.mesh.triangles.push_back({a, b, c});
  part.dressed.mesh.triangles.push_back({a, c, d});
}

std::vector<MaterialMesh> mesh_of(const Lattice& lattice) {
  std::map<std::uint32_t, Part> parts;
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      if (raised_corners(lattice, column, row) > 0)
        add_cell(parts[lattice.mix(column, row).wood], lattice, column, row);
  std::vector<MaterialMesh> meshes;
  for (auto& [wood, part] : parts) {
    part.dressed.material = Material::kBroadLeaf, part.dressed.feature = lattice.woods.woods[wood].surface.osm;
    meshes.push_back(std::move(part.dressed));
  }
  return meshes;
}

// A place in a cell, u and v from 0 to 1.
struct InCell {
  int column, row;
  double u, v;
};

InCell in_cell(const Canopy& canopy, Vec2 p) {
  const Vec2 steps = (p - canopy.box.min) * (1 / kCanopyCell_m);
  const double column = std::floor(steps.x), row = std::floor(steps.y);
  return {static_cast<int>(column), static_cast<int>(row), steps.x - column, steps.y - row};
}

bool is_below(const Canopy& canopy, Vec2 p) {
  const InCell in = in_cell(canopy, p);
  return canopy.box.contains_half_open(p) &&
         canopy.is_whole[static_cast<std::size_t>(in.row) * canopy.columns + static_cast<std::size_t>(in.column)];
}

[[maybe_unused]] bool is_multiple(double side_m) {
  return side_m / kCanopyCell_m == std::floor(side_m / kCanopyCell_m);
}

// The height of add_cell's triangles at a place in a whole cell.
double top_m_at(const Canopy& canopy, Vec2 p) {
  const auto [column, row, u, v] = in_cell(canopy, p);
  const double* const low = &canopy.tops_m[static_cast<std::size_t>(row) * (canopy.columns + 1) + column];
  const double* const high = low + canopy.columns + 1;
  return u >= v ? low[0] + u * (low[1] - low[0]) + v * (high[1] - low[1])
                : low[0] + v * (high[0] - low[0]) + u * (high[1] - high[0]);
}

}  // namespace

Canopy make_canopy(std::span<const Wood> woods, std::span<const PowerLineCorridor> corridors,
                   const PlacingContext& context, double tolerance_m, Month month) {
  assert(is_multiple(context.box.width()) && is_multiple(context.box.height()));
  Canopy canopy;
  if (woods.empty() || !has_detail(Detail::kWoodCanopies, tolerance_m)) return canopy;
  const WoodIndex map = index_woods(woods, context);
  const Lattice lattice =
      lattice_of(map, index_corridors(corridors, context.box.widened(kCanopyCell_m)), context.box, tolerance_m, month);
  canopy.meshes = mesh_of(lattice);
  canopy.box = context.box, canopy.columns = lattice.columns;
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      canopy.is_whole.push_back(raised_corners(lattice, column, row) == 4);
  for (int row = 0; row <= lattice.rows; ++row)
    for (int column = 0; column <= lattice.columns; ++column)
      canopy.tops_m.push_back(is_raised(lattice, column, row) ? place_of_vertex(lattice, column, row).z : 0);
  return canopy;
}

void remove_trees_below(Canopy& canopy, std::span<const Wood> woods, PlacedPlants& placed) {
  if (canopy.meshes.empty()) return;
  std::set<OsmId> ids;
  for (const Wood& wood : woods) ids.insert(wood.surface.osm);
  for (auto& [prototype, placements] : placed)
    std::erase_if(placements, [&](const Placement& tree) {
      if (!ids.contains(tree.feature) || !is_below(canopy, in_plan(tree.at))) return false;
      const double off_m = std::abs(tree.at.z + tree.scale - top_m_at(canopy, in_plan(tree.at)));
      canopy.error_m = std::max({canopy.error_m, off_m, tree.scale / 2});
      return true;
    });
}

}  // namespace citykiln::plants
