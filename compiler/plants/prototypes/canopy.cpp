#include "compiler/plants/prototypes/canopy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

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

// Brightness: gaps between crowns are darker than treetops.
constexpr double kDarkest = 0.8, kLightest = 1.5;

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

// Crowns of the relief: one in each square of a lattice, somewhere in its middle half. Their reach is that from which
// neighbours meet.
constexpr double kCrownStep_m = 6, kCrownReach_m = 5;

StableId id_of_place(Vec2 p) {
  const auto whole = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v))); };
  return stable_id(StableId{whole(p.x) << 32 ^ (whole(p.y) & 0xffffffffu)}, "canopy", 0);
}

// The crowns of the relief around a box: bowls upside down about the points of a jittered lattice, some higher than
// others. They are functions of the position alone.
class Relief {
 public:
  Relief(std::uint64_t seed, const Box2& box) : first_{square_of(box.min) - Vec2{1, 1}} {
    const Vec2 last = square_of(box.max) + Vec2{2, 2};
    columns_ = static_cast<int>(last.x - first_.x), rows_ = static_cast<int>(last.y - first_.y);
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const Vec2 square = first_ + Vec2{double(column), double(row)};
        const RandomSequence draw(seed, id_of_place(square), "crown");
        const Vec2 in_square{draw.between(0.25, 0.75, 0), draw.between(0.25, 0.75, 1)};
        crowns_.push_back({(square + in_square) * kCrownStep_m, draw.between(0.7, 1, 2)});
      }
  }

  // The share of the way from a gap between crowns, 0, to a treetop, 1, at a place in the box.
  double at(Vec2 p) const {
    const Vec2 in = square_of(p) - first_;
    double highest = 0;
    for (int i = 0; i < 9; ++i) {
      const int column = static_cast<int>(in.x) + i % 3 - 1, row = static_cast<int>(in.y) + i / 3 - 1;
      const Crown& crown = crowns_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
      const Vec2 off = p - crown.at;
      highest = std::max(highest, (1 - dot(off, off) / (kCrownReach_m * kCrownReach_m)) * crown.height);
    }
    return highest;
  }

 private:
  struct Crown {
    Vec2 at;
    double height;
  };

  static Vec2 square_of(Vec2 p) { return {std::floor(p.x / kCrownStep_m), std::floor(p.y / kCrownStep_m)}; }

  Vec2 first_;
  int columns_ = 0, rows_ = 0;
  std::vector<Crown> crowns_{};
};

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
  for (std::uint32_t i = 0; i < kTrees; ++i)
    add_tree(mix, wood, habitat, context, RandomSequence(context.seed, stable_id(id_of_place(p), "tree", i), "canopy"),
             month, ground);
  return mix;
}

// The step of the averages, unless cells are wider.
constexpr double kAverageStep_m = 8;

// Samples of a cell are so far apart, and one in four may lie outside dense woods: a path.
constexpr double kSampleStep_m = 4;
constexpr int kMostOthersShare = 4;

// Densities of closed woods have at least this share.
constexpr double kClosedShare = 0.7;

// Least height of trees as a share of the tolerance; lower ones are part of the ground's texture.
constexpr double kLeastHeight = 0.4;

// Range of vertices' heights as shares of the trees' height: gaps between crowns, and treetops.
constexpr double kLowest = 0.45, kHighest = 0.95;

// Depth of vertices that are not raised below the ground.
constexpr double kRimDepth_m = 1;

// Averages of crowns, on a lattice about a box.
class CrownAverages {
 public:
  CrownAverages(const WoodIndex& woods, const Box2& box, double step_m, Month month)
      : first_(box.min - Vec2{step_m, step_m}), step_m_(step_m) {
    columns_ = static_cast<int>(box.width() / step_m) + 3;
    const int rows = static_cast<int>(box.height() / step_m) + 3;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns_; ++column)
        all_.push_back(crown_average_at(woods, first_ + Vec2{double(column), double(row)} * step_m, month));
  }

  // Interpolated between the corners around a place that are in a wood; the wood is that of the nearest one.
  CrownAverage at(Vec2 p) const {
    const Vec2 in = (p - first_) * (1 / step_m_);
    const double column = std::floor(in.x), row = std::floor(in.y), u = in.x - column, v = in.y - row;
    CrownAverage mix;
    double sum = 0, largest = 0;
    for (const int right : {0, 1})
      for (const int up : {0, 1}) {
        const double share = (right == 1 ? u : 1 - u) * (up == 1 ? v : 1 - v);
        if (share == 0) continue;
        const CrownAverage& corner = all_[(static_cast<std::size_t>(row) + static_cast<std::size_t>(up)) * columns_ +
                                          static_cast<std::size_t>(column) + static_cast<std::size_t>(right)];
        if (corner.wood == ground::kNoLandCover) continue;
        if (share > largest) largest = share, mix.wood = corner.wood;
        sum += share, mix.height_m += share * corner.height_m;
        for (std::size_t c = 0; c < 3; ++c) mix.colour[c] += share * corner.colour[c];
      }
    if (sum == 0) return mix;
    mix.height_m /= sum;
    for (double& c : mix.colour) c /= sum;
    return mix;
  }

 private:
  Vec2 first_;
  double step_m_;
  int columns_ = 0;
  std::vector<CrownAverage> all_{};
};

// The cells of the box and of one row and column around it, and their vertices.
struct Lattice {
  const WoodIndex& woods;
  const Box2& box;
  double tolerance_m, cell_m;
  int columns, rows;  // of cells in the box
  CrownAverages crowns;
  Relief relief;
  std::vector<bool> closed{};

  Vec2 at(int column, int row) const { return box.min + Vec2{double(column), double(row)} * cell_m; }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * (columns + 2) + static_cast<std::size_t>(column + 1);
  }
  std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * (columns + 3) + static_cast<std::size_t>(column + 1);
  }
  bool is_closed(int column, int row) const { return closed[cell(column, row)]; }
  CrownAverage mix(int column, int row) const { return crowns.at(at(column, row)); }
};

bool is_closed_cell(const Lattice& lattice, const CorridorIndex& corridors, int column, int row) {
  for (const int c : {column, column + 1})
    for (const int r : {row, row + 1})
      if (lattice.mix(c, r).height_m < kLeastHeight * lattice.tolerance_m) return false;
  const int per_side = std::max(1, static_cast<int>(lattice.cell_m / kSampleStep_m));
  const int most_others = per_side * per_side / kMostOthersShare;
  int others = 0;
  for (int i = 0; i < per_side * per_side; ++i) {
    const Vec2 share{(i % per_side + 0.5) / per_side, (i / per_side + 0.5) / per_side};
    const Vec2 p = lattice.at(column, row) + share * lattice.cell_m;
    if (is_in_corridor(corridors, p)) return false;
    const SampleDensity density = density_at(lattice.woods, p);
    if (density.share >= kClosedShare && density.spacing_m > 0 && density.normal_z >= kLeastNormal_z) continue;
    if (++others > most_others || is_blocked_ground(lattice.woods.context.surfaces, p)) return false;
  }
  return true;
}

Lattice lattice_of(const WoodIndex& woods, const CorridorIndex& corridors, const Box2& box, double tolerance_m,
                   Month month) {
  const double cell_m = canopy_cell_m(tolerance_m);
  const auto cells = [&](double side_m) { return static_cast<int>(side_m / cell_m); };
  Lattice lattice{.woods = woods,
                  .box = box,
                  .tolerance_m = tolerance_m,
                  .cell_m = cell_m,
                  .columns = cells(box.width()),
                  .rows = cells(box.height()),
                  .crowns = CrownAverages(woods, box, std::max(cell_m, kAverageStep_m), month),
                  .relief = Relief(woods.context.seed, box.widened(2 * cell_m))};
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

// Height of a raised vertex above the ground; 0 where there is no wood.
double canopy_height_m(const Lattice& lattice, int column, int row) {
  const CrownAverage mix = lattice.mix(column, row);
  return mix.height_m * std::lerp(kLowest, kHighest, lattice.relief.at(lattice.at(column, row)));
}

// From the slopes of terrain and crowns.
Vec3 normal_of(const Lattice& lattice, int column, int row) {
  const Vec3 land = normal_at(lattice.woods.context.ground.terrain, lattice.at(column, row));
  const double own_m = canopy_height_m(lattice, column, row);
  const auto height_m = [&](int c, int r) {
    const double there_m = canopy_height_m(lattice, c, r);
    return there_m == 0 ? own_m : there_m;
  };
  const double across = 1 / (2 * lattice.cell_m);
  return unit(Vec3{land.x / land.z - (height_m(column + 1, row) - height_m(column - 1, row)) * across,
                   land.y / land.z - (height_m(column, row + 1) - height_m(column, row - 1)) * across, 1});
}

Vec3 place_of_vertex(const Lattice& lattice, int column, int row) {
  const Vec2 p = lattice.at(column, row);
  const double land = land_m(lattice.woods.context.ground, p);
  const bool is_up = is_raised(lattice, column, row);
  return snapped(at_height(p, is_up ? land + canopy_height_m(lattice, column, row) : land - kRimDepth_m));
}

materials::Tint canopy_tint(const Lattice& lattice, int column, int row) {
  const CrownAverage mix = lattice.mix(column, row);
  const double light = std::lerp(kDarkest, kLightest, lattice.relief.at(lattice.at(column, row)));
  const auto& base = values_of(Material::kBroadLeaf).base_colour;
  materials::Tint tint = materials::kNoTint;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] = static_cast<std::uint8_t>(
        std::clamp(light * mix.colour[c] / static_cast<double>(base[c]) * 255, 0.0, 255.0) + 0.5);
  return tint;
}

// The side of the squares into which canopies are divided.
constexpr double kBlock_m = 128;

// The canopy of one wood in one square: few enough vertices that files number them with 16 bits.
struct Part {
  MaterialMesh dressed{};
  std::map<std::size_t, std::uint32_t> vertices{};  // by Lattice::corner()

  std::uint32_t vertex(const Lattice& lattice, int column, int row) {
    const auto next = static_cast<std::uint32_t>(dressed.mesh.positions.size());
    const auto [at, is_new] = vertices.try_emplace(lattice.corner(column, row), next);
    if (!is_new) return at->second;
    dressed.mesh.positions.push_back(place_of_vertex(lattice, column, row));
    dressed.mesh.normals.push_back(normal_of(lattice, column, row));
    dressed.tints.push_back(canopy_tint(lattice, column, row));
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
  const int block = static_cast<int>(kBlock_m / lattice.cell_m);
  std::map<std::tuple<std::uint32_t, int, int>, Part> parts;  // by wood, row and column of blocks
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      if (raised_corners(lattice, column, row) > 0)
        add_cell(parts[{lattice.mix(column, row).wood, row / block, column / block}], lattice, column, row);
  std::vector<MaterialMesh> meshes;
  for (auto& [key, part] : parts) {
    part.dressed.material = Material::kBroadLeaf;
    part.dressed.feature = lattice.woods.woods[std::get<0>(key)].surface.osm;
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
  const Vec2 steps = (p - canopy.box.min) * (1 / canopy.cell_m);
  const double column = std::floor(steps.x), row = std::floor(steps.y);
  return {static_cast<int>(column), static_cast<int>(row), steps.x - column, steps.y - row};
}

bool is_below(const Canopy& canopy, Vec2 p) {
  const InCell in = in_cell(canopy, p);
  return canopy.box.contains_half_open(p) &&
         canopy.is_whole[static_cast<std::size_t>(in.row) * canopy.columns + static_cast<std::size_t>(in.column)];
}

[[maybe_unused]] bool is_multiple(double side_m) {
  return side_m / kWidestCanopyCell_m == std::floor(side_m / kWidestCanopyCell_m);
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

double canopy_cell_m(double tolerance_m) {
  constexpr double kTolerances = 3.5, kNarrowest_m = 2;
  double cell_m = kWidestCanopyCell_m;
  while (cell_m > std::max(kNarrowest_m, kTolerances * tolerance_m)) cell_m /= 2;
  return cell_m;
}

Canopy make_canopy(std::span<const Wood> woods, std::span<const PowerLineCorridor> corridors,
                   const PlacingContext& context, double tolerance_m, Month month) {
  assert(is_multiple(context.box.width()) && is_multiple(context.box.height()));
  Canopy canopy;
  if (woods.empty() || !has_detail(Detail::kWoodCanopies, tolerance_m)) return canopy;
  const WoodIndex map = index_woods(woods, context);
  const Lattice lattice = lattice_of(map, index_corridors(corridors, context.box.widened(kWidestCanopyCell_m)),
                                     context.box, tolerance_m, month);
  canopy.meshes = mesh_of(lattice);
  canopy.box = context.box, canopy.cell_m = lattice.cell_m, canopy.columns = lattice.columns;
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
