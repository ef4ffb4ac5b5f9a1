#include "compiler/bake/bake_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compiler/bake/baking.h"
#include "compiler/bake/clip_to_extent.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/bake/ground/ground_uvs.h"
#include "compiler/bake/ground/shown_ground.h"
#include "compiler/bake/ground/skirt.h"
#include "compiler/bake/image_uvs.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/parts/bake_buildings.h"
#include "compiler/bake/parts/bake_instances.h"
#include "compiler/bake/parts/bake_structures.h"
#include "compiler/bake/parts/bake_tufts.h"
#include "compiler/bake/place_things.h"
#include "compiler/bake/pole_wires.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/wires/generate.h"

namespace citykiln::bake {
namespace {

// The depth of the ground's edge at a clip: that of the tile's border, and enough to be seen.
double clip_skirt_m(double tolerance_m) {
  constexpr double kLeastEdge_m = 2;
  return std::max(kLeastEdge_m, kSkirtDepthTolerances * tolerance_m);
}

void bake_cells(Baking& baking, std::span<const ground::GroundMesh> cells, std::span<const ViewCell> seen,
                const scene::LandCover& cover, const Markings& markings) {
  assert(cells.size() == seen.size());
  const scene::Shown& shown = baking.header.shown;
  const bool is_clipped = !baking.header.clip.empty(), has_land_for_others = shows_land_for_others(shown);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const ground::GroundMesh& whole = cells[c];
    baking.certify_terrain(length(Vec2{whole.error_m, whole.border_error_m}), bounds_of(whole.mesh));
    std::optional<ground::GroundMesh> changed;
    if (is_clipped || has_land_for_others) changed = whole;
    RemovedEdges removed;
    if (is_clipped) removed = remove_beyond_clip(*changed, cover);
    if (has_land_for_others) changed = shown_ground(std::move(*changed), cover, shown);
    std::vector<LayeredMesh> meshes =
        material_meshes(changed ? *changed : whole, cover, markings, baking.header, baking.tolerance_m);
    std::erase_if(meshes, [&](const LayeredMesh& each) { return !is_shown(shown, each.layer); });
    if (!removed.empty())
      for (LayeredMesh& each : meshes) add_skirt(each.mesh, removed, clip_skirt_m(baking.tolerance_m));
    for (LayeredMesh& each : meshes) add_skirt(each.mesh, seen[c].skirt, seen[c].skirt_m);
    baking.take(std::move(meshes));
  }
}

Markings markings_of(const TileLevel& level, const std::vector<GeneratedSpan>& structures, double texel_m) {
  std::vector<roads::MarkingLayout> layouts = level.cover->layouts;
  const std::vector<roads::MarkingLayout> more = layouts_of(structures);
  layouts.insert(layouts.end(), more.begin(), more.end());
  return lay_out_markings(layouts, texel_m);
}

bool shows_markings(const Baking& baking) {
  return std::ranges::any_of(baking.meshes, [](const LayeredMesh& each) {
    return each.mesh.colour_source == materials::ColourSource::kByMarkingAtlas;
  });
}

// Adds the ground of the level's cells (128 m squares) with materials and skirts, then the structures. If the tile has
// markings, it gets the atlas TileLevel::markings or, if that is null, an atlas of its own markings. A single cell
// gets no atlas.
// @param structures  Result of generate_structures().
void bake_ground(Baking& baking, const TileLevel& level, std::vector<GeneratedSpan> structures) {
  Markings own;
  if (!level.markings) own = markings_of(level, structures, baking.texel_m());
  const Markings& markings = level.markings ? *level.markings : own;
  bake_cells(baking, level.cells, level.seen, *level.cover, markings);
  bake_cells(baking, level.beyond, level.seen_beyond, *level.cover, markings);
  bake_structures(baking, structures, markings);
  if (!level.markings)
    baking.tile.marking_atlas = std::move(own.atlas);
  else if (!baking.cell && shows_markings(baking))
    baking.tile.marking_atlas = markings.atlas;
}

// "bench", or "bench_2" for the second form of benches in the tile.
std::string name_of_form(const PlacedThing& thing) {
  return thing.number == 1 ? thing.form.kind : fmt::format("{}_{}", thing.form.kind, thing.number);
}

// The accounts of things by their source. Drawn things are not diagnosed when they are dropped.
constexpr std::array<const char*, static_cast<std::size_t>(ThingSource::kCount)> kThingAccounts = {
    "thing", "parked car", "street furniture", "person"};
using ThingAccounts = std::array<Account, kThingAccounts.size()>;

void count_things(const std::vector<const PlacedThing*>& things, const BakedThing& baked, ThingAccounts& accounts,
                  Report& report) {
  for (const PlacedThing* thing : things) {
    Account& account = accounts[static_cast<std::size_t>(thing->source)];
    ++account.in;
    if (!baked.primitives.empty())
      ++account.out;
    else if (thing->source != ThingSource::kRecipe)
      ++account.dropped[Code::kBelowTolerance];
    else
      report.drop(account, Code::kBelowTolerance, thing->placement.feature, baked.error_m);
  }
}

// Adds things as instances, in the accounts of kThingAccounts. Rules that ask for something impossible are diagnosed,
// kThingRuleErrors, once for each form and tile.
void bake_things(Baking& baking, const std::vector<PlacedThing>& things, const PrototypeCache& prototypes,
                 Report& report) {
  std::map<things::Form, std::vector<const PlacedThing*>> by_form;
  for (const PlacedThing& thing : things) by_form[thing.form].push_back(&thing);
  ThingAccounts accounts;
  for (const auto& [form, all] : by_form) {
    const BakedThing& baked = prototypes.thing(form, baking.tolerance_m);
    count_things(all, baked, accounts, report);
    for (const grammars::RuleFault& fault : baked.rule_faults)
      report.add({.code = Code::kThingRuleErrors,
                  .object = all.front()->placement.feature,
                  .size = static_cast<double>(fault.times),
                  .tag = fault.text});
    for (const PlacedThing* thing : all) baking.certify(baked.error_m, bounds_of(*thing));
    if (baked.primitives.empty()) continue;
    std::vector<Placement> placements;
    for (const PlacedThing* thing : all) placements.push_back(thing->placement);
    InstancedMesh instanced = instances_of(baking, name_of_form(*all.front()), placements, 1);
    for (std::size_t i = 0; i < all.size(); ++i) tilt(instanced, i, all[i]->up);
    instanced.primitives = baked.primitives;
    baking.tile.instanced.push_back(std::move(instanced));
  }
  for (std::size_t i = 0; i < accounts.size(); ++i) report.account("bake", kThingAccounts[i]) = accounts[i];
}

// The mean area of a mesh's triangles.
double mean_triangle_m2(const Mesh& mesh) {
  double twice_m2 = 0;
  for (const Triangle& t : mesh.triangles)
    twice_m2 += length(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
  return mesh.triangles.empty() ? 0 : twice_m2 / 2 / static_cast<double>(mesh.triangles.size());
}

// Walls beside streets, bridges and piers have no coordinates of their own. At tolerances that show no bumps,
// coordinates are worth their bytes on meshes of large faces, such as walls, not on the ribs and posts of others.
bool shows_planar_texture(const LayeredMesh& part, double tolerance_m) {
  constexpr double kLeastMean_m2 = 0.4;
  const bool is_built = part.layer == Layer::kProps || part.layer == Layer::kStructures;
  if (!is_built || !has_texture(part.mesh.material, tolerance_m) || has_holes(part.mesh.material)) return false;
  return has_detail(Detail::kGroundNormals, tolerance_m) || mean_triangle_m2(part.mesh.mesh) >= kLeastMean_m2;
}

// Frees each mesh when it is merged, so that no tile is held twice.
void merge_meshes(Baking& baking) {
  PrimitiveMap merged;
  for (LayeredMesh& each : baking.meshes) {
    LayeredMesh part = std::move(each);
    if (shows_planar_texture(part, baking.tolerance_m)) add_planar_uvs(part.mesh);
    merge(merged, part, baking.tile.origin, feature_index(baking.tile, part.mesh.feature));
  }
  baking.meshes.clear();
  baking.tile.primitives = primitives_of(std::move(merged));
}

// Whole metres, at the height of the lowest ground, which keeps offsets small.
Vec3 tile_origin(const Box2& box, const map::Heightfield& heights) {
  const auto lowest = std::min_element(heights.heights.begin(), heights.heights.end());
  return {box.min.x, box.min.y, std::floor(*lowest * map::kHeightQuantum_m)};
}

// The barriers that are bands. Hedges are bands where they are not plants, whole, in the tile of their first point.
std::vector<props::Barrier> bands_of(const Baking& baking) {
  std::vector<props::Barrier> bands = baking.chunk.barriers;
  const bool has_plants = baking.part || has_detail(Detail::kHedgePlants, baking.tolerance_m);
  std::erase_if(bands, [&](const props::Barrier& b) {
    const bool is_band = !has_plants && scene::is_anchored(baking.header, baking.chunk.tile, b.axis.front());
    return b.kind == map::BarrierKind::kHedge && !is_band;
  });
  return bands;
}

// A barrier or wires, clipped to the extent and closed there.
template <typename Generated>
Generated within_extent(Generated generated, const Box2& extent) {
  std::vector<MaterialMesh*> meshes;
  for (MaterialMesh& mesh : generated.meshes) meshes.push_back(&mesh);
  Mesh caps = clip_solid_to_extent(meshes, extent);
  if (!caps.triangles.empty()) {
    const MaterialMesh& body = generated.meshes.front();
    generated.meshes.push_back({std::move(caps), body.material, body.tint, body.feature});
  }
  std::erase_if(generated.meshes, [](const MaterialMesh& mesh) { return mesh.mesh.triangles.empty(); });
  return generated;
}

void bake_barriers_and_wires(Baking& baking, const SharedByLevels& shared, const PrototypeCache& prototypes,
                             Report& report) {
  const double tolerance_m = baking.tolerance_m;
  const Box2& extent = baking.header.extent;
  bake_each(
      baking, Layer::kProps, bands_of(baking), "barrier", report,
      [&](const auto& b) { return bounds_of(b, baking.chunk.heights); },
      [&](const auto& b) { return within_extent(props::generate(b, *shared.graded, tolerance_m), extent); });
  std::vector<wires::WireSpan> wire_spans = baking.chunk.wire_spans;
  if (baking.part || tolerance_m < kShowsFurniture_m)
    std::ranges::move(wires_of(shared.pole_spans, prototypes), std::back_inserter(wire_spans));
  bake_each(
      baking, Layer::kProps, wire_spans, "wires", report, [](const auto& span) { return bounds_of(span); },
      [&](const auto& span) { return within_extent(wires::generate(span, tolerance_m), extent); });
}

}  // namespace

BakedTile bake_level(const LevelRequest& request, TileLevel& level, const PrototypeCache& prototypes, int threads,
                     Report& report) {
  const auto& [header, chunk, part, cell, most_instances] = request;
  const double tolerance_m = level.tolerance_m;
  const SharedByLevels& shared = *level.shared;
  const ground::GradedTerrain& graded = *shared.graded;
  BakedTile tile{.tile = chunk.tile,
                 .origin = tile_origin(scene::box_of(header, chunk.tile), chunk.heights),
                 .tolerance_m = tolerance_m};
  if (part) tile.viewpoint = Viewpoint{part->levels.view.eye, part->levels.view.focal_px, 0};
  Baking baking{header, chunk, tolerance_m, tile, part, cell};

  const auto has_layer = [&](Layer layer) { return is_shown(header.shown, layer); };
  std::vector<GeneratedSpan> structures;
  if (has_layer(Layer::kStructures)) structures = generate_structures(baking, report);
  report.append(level.cell_report);
  bake_ground(baking, level, std::move(structures));
  bake_stairs(baking, shared.stairs);
  if (has_layer(Layer::kBuildings)) bake_buildings(baking, level, prototypes, threads, report);
  if (has_layer(Layer::kProps)) bake_barriers_and_wires(baking, shared, prototypes, report);
  report.append(shared.tree_report);
  bake_tree_pits(baking, shared);
  Placed placed = placed_in(baking, shared);
  baking.certify(placed.drawn_left_out_m, bounds_of(chunk.heights, scene::box_of(header, chunk.tile)));
  bake_canopy(baking, level, placed);
  add_features_of(baking, placed);
  BakedTufts tufts;
  if (has_layer(Layer::kPlants)) tufts = tufts_on(baking, level);
  for (const auto& [kind, placements] : tufts)
    for (const Placement& p : placements) baking.features.insert(p.feature);

  tile.features.assign(baking.features.begin(), baking.features.end());
  if (!cell) tile.attributes = attributes_of(chunk, tile.features, prototypes.thing_classes(), prototypes.species());
  merge_meshes(baking);
  bake_lamps(baking, placed.lamps, graded, report);
  bake_things(baking, placed.things, prototypes, report);
  bake_trees(baking, placed, prototypes, most_instances);
  bake_tufts(baking, tufts);
  snap_image_uvs(tile, cell && level.markings ? level.markings->atlas : tile.marking_atlas);
  if (!cell) tile.textures = textures_shown(tile, baking.texel_m(), prototypes.textures());
  return tile;
}

}  // namespace citykiln::bake
