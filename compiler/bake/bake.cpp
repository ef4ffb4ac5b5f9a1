#include "compiler/bake/bake.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/bake/dress_ground.h"
#include "compiler/bake/fire_ground.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/skirt.h"
#include "compiler/buildings/expand.h"
#include "compiler/plants/expand.h"
#include "compiler/props/expand.h"
#include "compiler/scene/ground_carving.h"
#include "compiler/structures/bore.h"
#include "compiler/structures/expand.h"

namespace citykiln::bake {
namespace {

using materials::DressedMesh;

// What a tile becomes, while it is being fired.
struct Firing {
  const scene::Header& header;
  const scene::Chunk& chunk;
  double tolerance_m;
  BakedTile& tile;
  const TilePart* part = nullptr;  // null: all of the tile
  std::vector<DressedMesh> meshes{};
  std::set<OsmId> features{OsmId{}};

  bool holds(const Bounds& bounds) const { return !part || is_in(*part, bounds); }
  // of roads; and of sheets and textures, which all parts of a view share
  double roads_m() const { return part ? roads_tolerance_m(part->levels, tolerance_m) : tolerance_m; }
  double texel_m() const { return part ? part->levels.finest_m : tolerance_m; }

  void take(std::vector<DressedMesh>&& more) {
    for (DressedMesh& mesh : more) {
      features.insert(mesh.feature);
      meshes.push_back(std::move(mesh));
    }
  }
  void certify(double error_m, const Bounds& bounds) {
    tile.error_m = std::max(tile.error_m, error_m);
    if (!part) return;
    double& largest_px = tile.seen_from->pixel_error;
    largest_px = std::max(largest_px, pixels_of(part->levels.view, error_m, bounds));
  }
};

// Expands every object of one kind; an object of which nothing is left counts as dropped by the tolerance.
template <typename Object, typename BoundsOf, typename Expand>
void fire_each(Firing& firing, const std::vector<Object>& objects, const char* kind, Report& report, BoundsOf bounds_of,
               Expand expand) {
  Account account;
  for (const Object& object : objects) {
    const Bounds bounds = bounds_of(object);
    if (!firing.holds(bounds)) continue;
    ++account.in;
    auto expanded = expand(object);
    firing.certify(expanded.error_m, bounds);
    if (expanded.meshes.empty()) {
      report.drop(account, Code::kBelowTolerance, object.id.osm, expanded.error_m);
      continue;
    }
    ++account.out;
    firing.take(std::move(expanded.meshes));
  }
  report.account("bake", kind) = account;
}

// A bridge or a tunnel, expanded.
struct Built {
  structures::Expanded expanded;
  Bounds bounds;
};

// Those that are part of the chunk's tile. A span of which nothing is left counts as dropped.
template <typename Expand>
void expand_spans(const Firing& firing, const std::vector<structures::Span>& spans, const char* kind, Report& report,
                  std::vector<Built>& all, Expand expand) {
  Account account;
  for (const structures::Span& span : spans) {
    const Bounds bounds = bounds_of(span);
    if (!scene::is_anchored(firing.header, firing.chunk.tile, span.axis.front()) || !firing.holds(bounds)) continue;
    ++account.in;
    structures::Expanded expanded = expand(span, firing.tolerance_m);
    if (expanded.meshes.empty() && expanded.marked.empty()) {
      report.drop(account, Code::kBelowTolerance, span.id.osm, 0);
      continue;
    }
    ++account.out;
    all.push_back({std::move(expanded), bounds});
  }
  report.account("bake", kind) = account;
}

// What is not bored was diagnosed when the map was compiled.
std::vector<Built> expand_structures(const Firing& firing, Report& report) {
  std::vector<Built> all;
  std::vector<structures::Span> bored = firing.chunk.tunnels;
  std::erase_if(bored, [](const structures::Span& tunnel) { return !tunnel.is_bored; });
  expand_spans(firing, firing.chunk.bridges, "bridge", report, all, structures::expand);
  expand_spans(firing, bored, "tunnel", report, all, structures::expand_bore);
  return all;
}

// What is painted on bridges and in tunnels goes onto the same sheet, after what is painted on the ground.
void fire_structures(Firing& firing, std::vector<Built>& structures, const Markings& markings,
                     std::size_t first_column) {
  for (auto& [built, bounds] : structures) {
    firing.certify(built.error_m, bounds);
    for (structures::MarkedMesh& marked : built.marked) {
      put_on_sheet(markings.columns[first_column++], marked.mesh);
      built.meshes.push_back(std::move(marked.mesh));
    }
    firing.take(std::move(built.meshes));
  }
}

// The cells of the tile that are made at this tolerance. Those of a tile that is made at one have skirts along the
// tile's border.
std::vector<SeenCell> cells_fired(const Firing& firing, const Box2& box) {
  std::vector<SeenCell> cells;
  if (!firing.part)
    for (const Box2& cell : cells_of(box))
      cells.push_back(
          {{cell, firing.tolerance_m, ground::all_sides(firing.tolerance_m)}, box, kSkirt * firing.tolerance_m});
  if (firing.part)
    for (const SeenCell& cell : cells_of(firing.part->levels, box))
      if (cell.level.tolerance_m == firing.tolerance_m) cells.push_back(cell);
  return cells;
}

void fire_ground(Firing& firing, const ground::Carving& carving, std::vector<Built> structures, const Box2& box,
                 int threads, Report& report) {
  const std::vector<SeenCell> cells = cells_fired(firing, box);
  scene::GroundCover cover;
  if (!cells.empty()) cover = scene::cover_of(firing.header, firing.chunk, firing.roads_m());
  const std::size_t first_of_structures = cover.patterns.size();
  for (const Built& built : structures)
    for (const structures::MarkedMesh& marked : built.expanded.marked) cover.patterns.push_back(marked.pattern);
  Markings markings = lay_out_markings(cover, firing.texel_m());
  std::vector<CellLevel> levels;
  for (const SeenCell& cell : cells) levels.push_back(cell.level);
  const std::vector<ground::GroundMesh> grounds = expand_cells(carving, cover.surfaces, levels, threads, report);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    firing.certify(length(Vec2{grounds[c].error_m, grounds[c].border_error_m}), bounds_of(grounds[c].mesh));
    std::vector<DressedMesh> dressed = dress(grounds[c], cover, markings, firing.header, firing.tolerance_m);
    for (DressedMesh& mesh : dressed) hang_skirt(mesh, cells[c].skirt, cells[c].skirt_m);
    firing.take(std::move(dressed));
  }
  fire_structures(firing, structures, markings, first_of_structures);
  firing.tile.sheet = std::move(markings.sheet);
}

std::uint32_t number_of(const BakedTile& tile, OsmId feature) {
  return static_cast<std::uint32_t>(std::lower_bound(tile.features.begin(), tile.features.end(), feature) -
                                    tile.features.begin());
}

// Shared meshes and where they stand. Nothing is left of them below the tolerance.
void fire_instances(Firing& firing, const std::string& name, const std::vector<DressedMesh>& meshes,
                    const std::vector<Placement>& placements) {
  if (meshes.empty() || placements.empty()) return;
  Merged merged;
  for (const DressedMesh& mesh : meshes) merge(merged, mesh, {}, 0);
  Instanced instanced{name, primitives_of(std::move(merged)), {}, {}, {}, {}};
  for (Primitive& primitive : instanced.primitives) primitive.features.clear();
  for (const Placement& p : placements) {
    instanced.translations.push_back(offset_from(firing.tile.origin, p.at));
    // half of the turn about z, from cos and sin of the whole
    const double c = std::sqrt(std::max(0.0, (1 + p.cos_yaw) / 2)), s = std::sqrt(std::max(0.0, (1 - p.cos_yaw) / 2));
    instanced.rotations.push_back(
        {0, 0, static_cast<float>(p.sin_yaw < 0 ? -s : s) + 0.0f, static_cast<float>(c) + 0.0f});
    instanced.scales.push_back(static_cast<float>(p.scale));
    instanced.features.push_back(number_of(firing.tile, p.feature));
  }
  firing.tile.instanced.push_back(std::move(instanced));
}

// Trees are placed before features are numbered, and written after.
plants::Placed place_trees(Firing& firing, const ground::SurfaceMap& map, const ground::Carving& carving,
                           const Box2& box, Report& report) {
  const scene::Chunk& chunk = firing.chunk;
  plants::Placed placed = plants::expand(chunk.trees, chunk.woods, map, carving, box, firing.header.seed, report);
  for (auto& placements : placed) {
    std::erase_if(placements, [&](const Placement& p) { return !firing.holds(bounds_of(p)); });
    for (const Placement& p : placements) firing.features.insert(p.feature);
  }
  return placed;
}

double tallest(const std::vector<Placement>& placements) {
  double tallest_m = 0;
  for (const Placement& p : placements) tallest_m = std::max(tallest_m, p.scale);
  return tallest_m;
}

void fire_trees(Firing& firing, const plants::Placed& placed) {
  constexpr const char* kNames[] = {"BroadLeaved", "NeedleLeaved"};
  for (std::size_t a = 0; a < placed.size(); ++a) {
    const double height_m = std::max(tallest(placed[a]), plants::kTallestTree_m);
    const auto archetype = plants::archetype_mesh(static_cast<plants::Archetype>(a), height_m, firing.tolerance_m);
    for (const Placement& p : placed[a]) firing.certify(archetype.error_per_m * p.scale, bounds_of(p));
    fire_instances(firing, kNames[a], archetype.meshes, placed[a]);
  }
}

// Lamps are placed before features are numbered, too. Mapped ones first.
struct Lamps {
  std::vector<props::StreetLamp> standing;
  std::size_t mapped = 0;
};

Lamps place_lamps(Firing& firing, const ground::SurfaceMap& map, const ground::Carving& carving, const Box2& box) {
  const scene::Chunk& chunk = firing.chunk;
  const auto is_elsewhere = [&](const props::StreetLamp& lamp) {
    return firing.part && !firing.holds(bounds_of(props::place(lamp, carving)));
  };
  Lamps lamps{props::mapped_lamps(chunk.lamps, chunk.roads), 0};
  std::erase_if(lamps.standing, is_elsewhere);
  lamps.mapped = lamps.standing.size();
  std::vector<props::StreetLamp> derived = props::lamps_of_streets(chunk.roads, chunk.lamps, map, box);
  std::erase_if(derived, is_elsewhere);
  lamps.standing.insert(lamps.standing.end(), derived.begin(), derived.end());
  for (const props::StreetLamp& lamp : lamps.standing) firing.features.insert(lamp.feature);
  return lamps;
}

// What stands of one kind; false where the tolerance leaves nothing of it.
bool fire_lamps(Firing& firing, const Lamps& lamps, const ground::Carving& carving, props::LampKind kind) {
  constexpr const char* kNames[] = {"PostTopLamp", "ArmLamp"};
  std::vector<Placement> placements;
  for (const props::StreetLamp& lamp : lamps.standing)
    if (lamp.kind == kind) placements.push_back(props::place(lamp, carving));
  const props::Expanded lamp = props::lamp_mesh(kind, tallest(placements), firing.tolerance_m);
  for (const Placement& p : placements) firing.certify(lamp.error_m, bounds_of(p));
  fire_instances(firing, kNames[static_cast<std::size_t>(kind)], lamp.meshes, placements);
  return !lamp.meshes.empty();
}

// Only what somebody mapped is named where the tolerance drops it.
void fire_lamps(Firing& firing, const Lamps& lamps, const ground::Carving& carving, Report& report) {
  const bool is_left[] = {fire_lamps(firing, lamps, carving, props::LampKind::kPostTop),
                          fire_lamps(firing, lamps, carving, props::LampKind::kArm)};
  Account mapped, derived;
  for (std::size_t i = 0; i < lamps.standing.size(); ++i) {
    const props::StreetLamp& lamp = lamps.standing[i];
    Account& account = i < lamps.mapped ? mapped : derived;
    ++account.in;
    if (is_left[static_cast<std::size_t>(lamp.kind)])
      ++account.out;
    else if (i < lamps.mapped)
      report.drop(account, Code::kBelowTolerance, lamp.feature, lamp.height_m);
    else
      ++account.dropped[Code::kBelowTolerance];
  }
  report.account("bake", "lamp") = mapped;
  report.account("bake", "derived lamp") = derived;
}

void merge_meshes(Firing& firing) {
  Merged merged;
  for (const DressedMesh& mesh : firing.meshes)
    merge(merged, mesh, firing.tile.origin, number_of(firing.tile, mesh.feature));
  firing.tile.primitives = primitives_of(std::move(merged));
}

// Whole metres; the height of the lowest ground keeps offsets small.
Vec3 origin_of(const Box2& box, const map::Heightfield& heights) {
  const auto lowest = std::min_element(heights.heights.begin(), heights.heights.end());
  return {box.min.x, box.min.y, std::floor(*lowest * map::kHeightQuantum_m)};
}

// All of the tile, or what of it the firing holds.
void fire(Firing& firing, int threads, Report& report) {
  const scene::Header& header = firing.header;
  const scene::Chunk& chunk = firing.chunk;
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::Surface> surfaces = scene::surfaces_of(chunk);

  const ground::Carving carving = scene::carving_of(header, chunk, firing.tolerance_m);
  fire_ground(firing, carving, expand_structures(firing, report), box, threads, report);
  fire_each(
      firing, chunk.buildings, "building", report, [](const auto& b) { return bounds_of(b); },
      [&](const auto& b) { return buildings::expand(b, header.seed, firing.tolerance_m); });
  fire_each(
      firing, chunk.barriers, "barrier", report, [&](const auto& b) { return bounds_of(b, chunk.heights); },
      [&](const auto& b) { return props::expand(b, carving, firing.tolerance_m); });
  const ground::SurfaceMap map = ground::map_surfaces(surfaces, box.widened(scene::kHalo_m));
  const plants::Placed trees = place_trees(firing, map, carving, box, report);
  const Lamps lamps = place_lamps(firing, map, carving, box);

  firing.tile.features.assign(firing.features.begin(), firing.features.end());
  merge_meshes(firing);
  firing.tile.textures = textures_shown(firing.tile.primitives, firing.texel_m(), header.seed);
  fire_trees(firing, trees);
  fire_lamps(firing, lamps, carving, report);
}

BakedTile empty_tile(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m) {
  return {chunk.tile, origin_of(scene::box_of(header, chunk.tile), chunk.heights), tolerance_m, 0, {}, {}, {}};
}

}  // namespace

BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads,
               Report& report) {
  BakedTile tile = empty_tile(header, chunk, tolerance_m);
  Firing firing{header, chunk, tolerance_m, tile};
  fire(firing, threads, report);
  return tile;
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& levels,
                            int threads) {
  const std::vector<double> tolerances_m = tolerances_of(levels, header, chunk);
  std::vector<BakedTile> parts;
  Report ignored;
  for (const double tolerance_m : tolerances_m) {
    BakedTile& tile = parts.emplace_back(empty_tile(header, chunk, tolerance_m));
    tile.seen_from = SeenFrom{levels.view.eye, levels.view.focal_px, 0};
    const TilePart part{levels, tolerances_m, tolerance_m};
    Firing firing{header, chunk, tolerance_m, tile, &part};
    fire(firing, threads, ignored);
  }
  return parts;
}

}  // namespace citykiln::bake
