#include "compiler/bake/bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "compiler/bake/dress_ground.h"
#include "compiler/bake/fire_ground.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/skirt.h"
#include "compiler/buildings/expand.h"
#include "compiler/contract/for_each_slot.h"
#include "compiler/plants/expand.h"
#include "compiler/props/expand.h"
#include "compiler/scene/ground_carving.h"
#include "compiler/structures/bore.h"
#include "compiler/structures/expand.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {
namespace {

using materials::DressedMesh;

// What stands along streets. Mapped ones first.
struct Lamps {
  std::vector<props::StreetLamp> standing;
  std::size_t mapped = 0;
};

// What the levels on one side of kPlainRoads_m have in common: how the ground is carved, and what stands on it.
struct Common {
  ground::Carving carving;
  plants::Placed trees;
  Report of_trees;
  Lamps lamps;
  std::vector<structures::Stairs> stairs;
};

// One an object of the chunk.
using Houses = std::vector<buildings::Expanded>;

// One level's part of the ground, and its houses where levels share what those are made of.
struct Level {
  double tolerance_m;
  std::shared_ptr<const Common> common;
  scene::GroundCover cover;
  std::vector<SeenCell> seen;
  std::vector<ground::GroundMesh> cells{};
  Report of_cells{};
  std::optional<Houses> houses{};
  Report of_houses{};
};

Lamps place_lamps(const scene::Chunk& chunk, const ground::SurfaceMap& map, const Box2& box) {
  Lamps lamps{props::mapped_lamps(chunk.lamps, chunk.roads), chunk.lamps.size()};
  const std::vector<props::StreetLamp> derived = props::lamps_of_streets(chunk.roads, chunk.lamps, map, box);
  lamps.standing.insert(lamps.standing.end(), derived.begin(), derived.end());
  return lamps;
}

Common common_at(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m) {
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::Surface> surfaces = scene::surfaces_of(chunk);
  const ground::SurfaceMap map = ground::map_surfaces(surfaces, box.widened(scene::kHalo_m));
  Common common{scene::carving_of(header, chunk, tolerance_m), {}, {}, place_lamps(chunk, map, box), {}};
  common.trees = plants::expand(chunk.trees, chunk.woods, map, common.carving, box, header.seed, common.of_trees);
  for (const roads::Road& road : chunk.roads)
    if (road.surface == map::SurfaceClass::kSteps)
      common.stairs.push_back(structures::stairs_on(road, map, common.carving, box));
  std::erase_if(common.stairs, [](const structures::Stairs& stairs) { return stairs.mesh.triangles.empty(); });
  return common;
}

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
  // of sheets and textures, which all parts of a view share
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

// Houses at several tolerances, with a report each. Rules are read once; houses are worked on side by side and told in
// order. What `holds` denies is left empty.
std::vector<Houses> expand_houses(const scene::Header& header, const scene::Chunk& chunk,
                                  std::span<const double> tolerances_m, int threads, std::span<Report> reports,
                                  const std::function<bool(const buildings::Building&)>& holds) {
  const std::vector<buildings::Building>& all = chunk.buildings;
  const buildings::Rulebook rulebook = buildings::rulebook_of(buildings::styles_of(all), header.rules);
  std::vector<std::vector<Report>> told(all.size(), std::vector<Report>(tolerances_m.size()));
  std::vector<Houses> by_house = for_each_slot<Houses>(all.size(), threads, [&](std::size_t i) {
    if (!holds(all[i])) return Houses(tolerances_m.size());
    return buildings::expand(all[i], rulebook, header.seed, tolerances_m, told[i]);
  });
  std::vector<Houses> by_level(tolerances_m.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t l = 0; l < tolerances_m.size(); ++l) {
      by_level[l].push_back(std::move(by_house[i][l]));
      reports[l].append(told[i][l]);
    }
  return by_level;
}

// Pictures of facades go onto the tile's atlas, and the faces that show them to the house's other meshes.
void put_on_atlas(Firing& firing, Houses& houses) {
  std::vector<imprint::Picture> pictures;
  for (buildings::Expanded& house : houses)
    for (buildings::ImprintedMesh& face : house.imprinted) pictures.push_back(std::move(face.picture));
  imprint::AtlasLayout layout = imprint::lay_out(pictures, firing.tolerance_m);
  std::size_t picture = 0;
  for (buildings::Expanded& house : houses)
    for (buildings::ImprintedMesh& face : house.imprinted) {
      for (Vec2& uv : face.mesh.uvs) uv = uv + layout.at_m[picture];
      house.meshes.push_back(std::move(face.mesh));
      ++picture;
    }
  firing.tile.imprints = std::move(layout.atlas);
}

void fire_buildings(Firing& firing, Level& level, int threads, Report& report) {
  const std::vector<buildings::Building>& all = firing.chunk.buildings;
  if (!level.houses)
    level.houses = std::move(expand_houses(firing.header, firing.chunk, std::span(&firing.tolerance_m, 1), threads,
                                           std::span(&level.of_houses, 1),
                                           [&](const auto& b) { return firing.holds(bounds_of(b)); })
                                 .front());
  report.append(level.of_houses);
  put_on_atlas(firing, *level.houses);
  fire_each(
      firing, all, "building", report, [](const auto& b) { return bounds_of(b); },
      [&](const auto& b) { return std::move((*level.houses)[static_cast<std::size_t>(&b - all.data())]); });
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

// Stairs lie on the ground, which is a ramp below them: where the tolerance does not see them, that stays.
void fire_stairs(Firing& firing, const std::vector<structures::Stairs>& all) {
  for (const structures::Stairs& stairs : all) {
    const Bounds bounds = bounds_of(stairs.mesh);
    if (!firing.holds(bounds)) continue;
    if (stairs.error_m <= firing.tolerance_m)
      firing.certify(stairs.error_m, bounds);
    else
      firing.take({{stairs.mesh, materials::Material::kStone, materials::kNoTint, stairs.feature}});
  }
}

void fire_ground(Firing& firing, Level& level, std::vector<Built> structures) {
  scene::GroundCover& cover = level.cover;
  const std::size_t first_of_structures = cover.patterns.size();
  for (const Built& built : structures)
    for (const structures::MarkedMesh& marked : built.expanded.marked) cover.patterns.push_back(marked.pattern);
  Markings markings = lay_out_markings(cover, firing.texel_m());
  for (std::size_t c = 0; c < level.cells.size(); ++c) {
    const ground::GroundMesh& ground = level.cells[c];
    firing.certify(length(Vec2{ground.error_m, ground.border_error_m}), bounds_of(ground.mesh));
    std::vector<DressedMesh> dressed = dress(ground, cover, markings, firing.header, firing.tolerance_m);
    for (DressedMesh& mesh : dressed) hang_skirt(mesh, level.seen[c].skirt, level.seen[c].skirt_m);
    firing.take(std::move(dressed));
  }
  fire_structures(firing, structures, markings, first_of_structures);
  firing.tile.sheet = std::move(markings.sheet);
}

// What of the trees and lamps the firing holds.
struct Placed {
  plants::Placed trees;
  Lamps lamps;
};

Placed placed_in(const Firing& firing, const Common& common) {
  Placed placed{common.trees, common.lamps};
  if (!firing.part) return placed;
  for (auto& placements : placed.trees)
    std::erase_if(placements, [&](const Placement& p) { return !firing.holds(bounds_of(p)); });
  placed.lamps = {};
  for (std::size_t i = 0; i < common.lamps.standing.size(); ++i) {
    const props::StreetLamp& lamp = common.lamps.standing[i];
    if (!firing.holds(bounds_of(props::place(lamp, common.carving)))) continue;
    placed.lamps.standing.push_back(lamp);
    if (i < common.lamps.mapped) ++placed.lamps.mapped;
  }
  return placed;
}

// What is placed is named before features are numbered, and written after.
void name_placed(Firing& firing, const Placed& placed) {
  for (const auto& placements : placed.trees)
    for (const Placement& p : placements) firing.features.insert(p.feature);
  for (const props::StreetLamp& lamp : placed.lamps.standing) firing.features.insert(lamp.feature);
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

// each mesh goes when it is merged: a tile is never there twice
void merge_meshes(Firing& firing) {
  Merged merged;
  for (DressedMesh& each : firing.meshes) {
    const DressedMesh mesh = std::move(each);
    merge(merged, mesh, firing.tile.origin, number_of(firing.tile, mesh.feature));
  }
  firing.meshes.clear();
  firing.tile.primitives = primitives_of(std::move(merged));
}

// Whole metres; the height of the lowest ground keeps offsets small.
Vec3 origin_of(const Box2& box, const map::Heightfield& heights) {
  const auto lowest = std::min_element(heights.heights.begin(), heights.heights.end());
  return {box.min.x, box.min.y, std::floor(*lowest * map::kHeightQuantum_m)};
}

BakedTile fire_level(const scene::Header& header, const scene::Chunk& chunk, Level& level, const TilePart* part,
                     int threads, Report& report) {
  const double tolerance_m = level.tolerance_m;
  const Common& common = *level.common;
  BakedTile tile{chunk.tile, origin_of(scene::box_of(header, chunk.tile), chunk.heights), tolerance_m, 0, {}, {}, {}};
  if (part) tile.seen_from = SeenFrom{part->levels.view.eye, part->levels.view.focal_px, 0};
  Firing firing{header, chunk, tolerance_m, tile, part};

  std::vector<Built> structures = expand_structures(firing, report);
  report.append(level.of_cells);
  fire_ground(firing, level, std::move(structures));
  fire_stairs(firing, common.stairs);
  fire_buildings(firing, level, threads, report);
  fire_each(
      firing, chunk.barriers, "barrier", report, [&](const auto& b) { return bounds_of(b, chunk.heights); },
      [&](const auto& b) { return props::expand(b, common.carving, tolerance_m); });
  report.append(common.of_trees);
  const Placed placed = placed_in(firing, common);
  name_placed(firing, placed);

  tile.features.assign(firing.features.begin(), firing.features.end());
  merge_meshes(firing);
  tile.textures = textures_shown(tile.primitives, firing.texel_m(), header.seed);
  fire_trees(firing, placed.trees);
  fire_lamps(firing, placed.lamps, common.carving, report);
  return tile;
}

// What the tile's levels on either side of kPlainRoads_m have in common, each made when it is first asked for.
struct Commons {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::array<std::shared_ptr<const Common>, 2> made{};

  std::shared_ptr<const Common> at(double tolerance_m) {
    std::shared_ptr<const Common>& common = made[tolerance_m < scene::kPlainRoads_m ? 0 : 1];
    if (!common) common = std::make_shared<Common>(common_at(header, chunk, tolerance_m));
    return common;
  }
};

// All cells of a tile at one tolerance have skirts along the tile's border.
std::vector<SeenCell> cells_at(const Box2& tile, double tolerance_m) {
  std::vector<SeenCell> cells;
  for (const Box2& cell : cells_of(tile))
    cells.push_back({{cell, tolerance_m, ground::all_sides(tolerance_m)}, tile, kSkirt * tolerance_m});
  return cells;
}

// All but the cells.
std::vector<Level> levels_of(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Commons commons{header, chunk};
  std::vector<Level> levels;
  for (const double tolerance_m : ladder_m)
    levels.push_back({tolerance_m, commons.at(tolerance_m), scene::cover_of(header, chunk, tolerance_m),
                      cells_at(box, tolerance_m)});
  return levels;
}

void expand_grounds(std::span<Level> levels, const Box2& box, int threads) {
  std::vector<GroundLevel> grounds;
  for (const Level& level : levels) grounds.push_back({level.common->carving, level.cover.surfaces, level.tolerance_m});
  std::vector<Report> reports(levels.size());
  std::vector<std::vector<ground::GroundMesh>> cells = expand_cells(grounds, box, threads, reports);
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i].cells = std::move(cells[i]), levels[i].of_cells = std::move(reports[i]);
}

// Levels that show facades as pictures share what these are made of.
void expand_imprinted(const scene::Header& header, const scene::Chunk& chunk, std::span<Level> levels, int threads) {
  std::vector<Level*> imprinted;
  std::vector<double> tolerances_m;
  for (Level& level : levels)
    if (level.tolerance_m >= buildings::kImprinted_m)
      imprinted.push_back(&level), tolerances_m.push_back(level.tolerance_m);
  if (imprinted.empty()) return;
  std::vector<Report> reports(imprinted.size());
  std::vector<Houses> houses =
      expand_houses(header, chunk, tolerances_m, threads, reports, [](const auto&) { return true; });
  for (std::size_t i = 0; i < imprinted.size(); ++i)
    imprinted[i]->houses = std::move(houses[i]), imprinted[i]->of_houses = std::move(reports[i]);
}

// The cells of a tile that a view asks for at a tolerance.
std::vector<SeenCell> cells_seen(const ViewLevels& view, const Box2& tile, double tolerance_m) {
  std::vector<SeenCell> cells = cells_of(view, tile);
  std::erase_if(cells, [&](const SeenCell& cell) { return cell.level.tolerance_m != tolerance_m; });
  return cells;
}

// One a part, with its cells.
std::vector<Level> levels_seen(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                               std::span<const double> tolerances_m, int threads) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Commons commons{header, chunk};
  std::vector<Level> levels;
  for (const double tolerance_m : tolerances_m) {
    Level& level =
        levels.emplace_back(Level{tolerance_m, commons.at(tolerance_m), {}, cells_seen(view, box, tolerance_m)});
    if (level.seen.empty()) continue;
    level.cover = scene::cover_of(header, chunk, roads_tolerance_m(view, tolerance_m));
    std::vector<CellLevel> cells;
    for (const SeenCell& cell : level.seen) cells.push_back(cell.level);
    level.cells = expand_cells(level.common->carving, level.cover.surfaces, cells, threads, level.of_cells);
  }
  return levels;
}

}  // namespace

struct PreparedTile {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::vector<Level> levels;
};

std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> ladder_m, int threads) {
  PreparedTile prepared{header, chunk, levels_of(header, chunk, ladder_m)};
  expand_grounds(prepared.levels, scene::box_of(header, chunk.tile), threads);
  expand_imprinted(header, chunk, prepared.levels, threads);
  return std::make_shared<PreparedTile>(std::move(prepared));
}

BakedTile fire_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report) {
  Level own = std::move(prepared.levels[level]);
  return fire_level(prepared.header, prepared.chunk, own, nullptr, threads, report);
}

BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads,
               Report& report) {
  return std::move(bake(header, chunk, std::span(&tolerance_m, 1), threads, report).front());
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                            int threads, Report& report) {
  struct Slot {
    BakedTile tile;
    Report report;
  };
  const std::shared_ptr<PreparedTile> prepared = prepare(header, chunk, ladder_m, threads);
  std::vector<Slot> slots = for_each_slot<Slot>(ladder_m.size(), threads, [&](std::size_t i) {
    Slot slot;
    slot.tile = fire_prepared(*prepared, i, threads, slot.report);
    return slot;
  });
  std::vector<BakedTile> tiles;
  for (Slot& slot : slots) {
    report.append(slot.report);
    tiles.push_back(std::move(slot.tile));
  }
  return tiles;
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                            int threads) {
  const std::vector<double> tolerances_m = tolerances_of(view, header, chunk);
  std::vector<Level> levels = levels_seen(header, chunk, view, tolerances_m, threads);
  return for_each_slot<BakedTile>(levels.size(), threads, [&](std::size_t i) {
    const TilePart part{view, tolerances_m, tolerances_m[i]};
    Report ignored;
    return fire_level(header, chunk, levels[i], &part, threads, ignored);
  });
}

}  // namespace citykiln::bake
