#include "compiler/verify/check_usd.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "compiler/bake/bake.h"
#include "compiler/bake/far/bend.h"
#include "compiler/contract/findings/assumption_names.h"
#include "compiler/verify/prepare_tile.h"
#include "exporters/file.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/joined_attributions.h"
#include "exporters/run_files.h"
#include "exporters/usd/read_layer.h"
#include "exporters/usd/usd_names.h"

namespace citykiln::verify {
namespace {

using bake::BakedTile;
using exporters::joined_attributions;
using exporters::UsdReadDictionary;
using exporters::UsdReadLayer;
using exporters::UsdReadPrim;
using Numbers = std::vector<double>;

namespace fs = std::filesystem;

Result<UsdReadLayer> read(const std::string& path) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  return exporters::read_usd_layer(*bytes, path);
}

// Returns the numbers with this name; none if it is missing.
const Numbers& numbers_of(const UsdReadDictionary& values, const std::string& name) {
  static const Numbers kNone;
  const auto found = values.find(name);
  return found == values.end() ? kNone : found->second.numbers;
}

std::vector<std::string> texts_of(const UsdReadDictionary& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? std::vector<std::string>() : found->second.texts;
}

std::vector<std::string> targets_of(const UsdReadPrim& prim, const std::string& name) {
  const auto found = prim.targets.find(name);
  return found == prim.targets.end() ? std::vector<std::string>() : found->second;
}

bool is_number(const UsdReadDictionary& values, const std::string& name, double expected) {
  return numbers_of(values, name) == Numbers{expected};
}

Numbers numbers_of(Vec3 v) { return {v.x, v.y, v.z}; }

// ---- whether a layer holds together ----

struct Layer {
  const UsdReadLayer& read;
  const std::string& name;
  const std::string& folder;  ///< The folder of the layer's file.
  std::set<std::string> paths{};
  std::size_t features = 0;
};

bool are_indices(const Numbers& indices, std::size_t count) {
  return std::ranges::all_of(indices, [&](double i) { return i >= 0 && i < static_cast<double>(count); });
}

// Returns the bounds of points: the three lowest coordinates, then the three highest.
Numbers bounds_of(const Numbers& points) {
  Numbers bounds = {1e300, 1e300, 1e300, -1e300, -1e300, -1e300};
  for (std::size_t i = 0; i < points.size(); ++i) {
    bounds[i % 3] = std::min(bounds[i % 3], points[i]);
    bounds[3 + i % 3] = std::max(bounds[3 + i % 3], points[i]);
  }
  return bounds;
}

// Returns the number of values that a primvar must have.
std::size_t values_of_rate(const UsdReadPrim& mesh, const std::string& primvar, std::size_t vertices,
                           std::size_t faces) {
  const auto rate = mesh.interpolations.find(primvar);
  if (rate == mesh.interpolations.end() || rate->second == "constant") return 1;
  return rate->second == "uniform" ? faces : vertices;
}

// Returns the first fault of a mesh; empty if it has none.
std::string fault_of_mesh(const Layer& layer, const UsdReadPrim& mesh) {
  const Numbers &points = numbers_of(mesh.values, "points"), &counts = numbers_of(mesh.values, "faceVertexCounts"),
                &indices = numbers_of(mesh.values, "faceVertexIndices");
  const std::size_t vertices = points.size() / 3;
  if (points.empty() || points.size() % 3 != 0) return "has no points";
  if (!std::ranges::all_of(counts, [](double n) { return n == 3; }) || indices.size() != 3 * counts.size())
    return "has faces that are no triangles";
  if (!are_indices(indices, vertices)) return "has an index beyond its points";
  if (numbers_of(mesh.values, "extent") != bounds_of(points)) return "states another extent than that of its points";
  if (numbers_of(mesh.values, "normals").size() != points.size()) return "has not one normal for each point";
  const Numbers& st = numbers_of(mesh.values, "primvars:st");
  if (!st.empty() && st.size() != 2 * vertices) return "has not one texture coordinate for each point";
  const std::size_t colours = numbers_of(mesh.values, "primvars:displayColor").size() / 3;
  const Numbers& colour_indices = numbers_of(mesh.values, "primvars:displayColor:indices");
  const std::size_t wanted = values_of_rate(mesh, "primvars:displayColor", vertices, counts.size());
  if ((colour_indices.empty() ? colours : colour_indices.size()) != wanted || !are_indices(colour_indices, colours))
    return "has not one colour for each point";
  const Numbers& features = numbers_of(mesh.values, "primvars:feature");
  if (!features.empty() && features.size() != values_of_rate(mesh, "primvars:feature", vertices, counts.size()))
    return "has not one feature for each face or point";
  if (!are_indices(features, layer.features)) return "has a feature beyond the table";
  for (const std::string& target : targets_of(mesh, "material:binding"))
    if (layer.paths.contains(target)) return "";
  return "has no material";
}

std::string fault_of_instancer(const Layer& layer, const UsdReadPrim& instancer) {
  const std::vector<std::string> prototypes = targets_of(instancer, "prototypes");
  const Numbers& indices = numbers_of(instancer.values, "protoIndices");
  const auto has = [&](const char* name, std::size_t width) {
    return numbers_of(instancer.values, name).size() == width * indices.size();
  };
  if (!are_indices(indices, prototypes.size())) return "has an index beyond its prototypes";
  if (!has("positions", 3) || !has("orientations", 4) || !has("scales", 3) || !has("ids", 1) ||
      !has("primvars:feature", 1))
    return "has not one value for each instance";
  const Numbers& ids = numbers_of(instancer.values, "ids");
  if (std::set<double>(ids.begin(), ids.end()).size() != ids.size()) return "has an id twice";
  if (!are_indices(numbers_of(instancer.values, "primvars:feature"), layer.features))
    return "has a feature beyond the table";
  const bool all_there = std::ranges::all_of(prototypes, [&](const auto& p) { return layer.paths.contains(p); });
  return all_there ? "" : "has a prototype that is not there";
}

std::string fault_of_shader(const Layer& layer, const UsdReadPrim& shader) {
  for (const std::string& file : texts_of(shader.values, "inputs:file")) {
    std::error_code none;
    if (!fs::exists(fs::path(layer.folder) / file, none)) return "has a texture that is not there: " + file;
  }
  for (const auto& [name, targets] : shader.targets)
    for (const std::string& target : targets)
      if (!layer.paths.contains(target.substr(0, target.find('.')))) return "is connected to nothing: " + target;
  return "";
}

void check_prims(const Layer& layer, CheckResults& results) {
  for (const UsdReadPrim& prim : layer.read.prims) {
    std::string fault;
    if (prim.type == "Mesh") fault = fault_of_mesh(layer, prim);
    if (prim.type == "PointInstancer") fault = fault_of_instancer(layer, prim);
    if (prim.type == "Shader" || prim.type == "Material") fault = fault_of_shader(layer, prim);
    results.usd_layers.test(fault.empty(), fmt::format("{}: {} {}", layer.name, prim.path, fault));
  }
}

// ---- whether it is the tile ----

// The meshes below a prim, without those of instancers, in order.
std::vector<const UsdReadPrim*> meshes_below(const UsdReadLayer& layer, const std::string& parent) {
  std::vector<const UsdReadPrim*> meshes;
  for (const UsdReadPrim& prim : layer.prims)
    if (prim.type == "Mesh" && prim.path.starts_with(parent + "/") &&
        prim.path.find('/', parent.size() + 1) == std::string::npos)
      meshes.push_back(&prim);
  return meshes;
}

// True if a mesh has the points and the triangles of a primitive, in their order; leaves with their backs.
bool is_same(const UsdReadPrim& mesh, const bake::Primitive& front) {
  const bool is_backed = front.colour_source == materials::ColourSource::kByCutout && exporters::has_backs(front);
  const bake::Primitive both = is_backed ? exporters::with_backs(front) : bake::Primitive{};
  const bake::Primitive& p = is_backed ? both : front;
  const Numbers &points = numbers_of(mesh.values, "points"), &indices = numbers_of(mesh.values, "faceVertexIndices");
  if (points.size() != 3 * p.positions.size() || indices.size() != 3 * p.triangles.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] != static_cast<double>(p.positions[i / 3][i % 3])) return false;
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] != static_cast<double>(p.triangles[i / 3][i % 3])) return false;
  return true;
}

void test_meshes(const Layer& layer, const std::string& parent, std::span<const bake::Primitive> primitives,
                 CheckResults& results) {
  const auto meshes = meshes_below(layer.read, parent);
  bool same = meshes.size() == primitives.size();
  for (std::size_t i = 0; same && i < meshes.size(); ++i) same = is_same(*meshes[i], primitives[i]);
  results.usd_same.test_all(primitives.size(), same,
                            fmt::format("{}: the meshes of {} are others than those of the .glb", layer.name, parent));
}

// The attributes of the instances of a layer of a tile, prototype by prototype, as a PointInstancer has them.
struct InstanceNumbers {
  Numbers prototypes, positions, orientations, scales, features;
};

void add_instances(InstanceNumbers& all, const bake::InstancedMesh& mesh, std::size_t prototype) {
  for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
    const bake::Float4& turn = mesh.rotations[i];
    all.prototypes.push_back(static_cast<double>(prototype));
    all.positions.insert(all.positions.end(), mesh.translations[i].begin(), mesh.translations[i].end());
    // the real part first
    all.orientations.insert(all.orientations.end(), {turn[3], turn[0], turn[1], turn[2]});
    all.scales.insert(all.scales.end(), 3, mesh.scales[i]);
    all.features.push_back(mesh.features[i]);
  }
}

// True if numbers are equal within the rounding of half precision, for numbers of at most 1.
bool are_halves_of(const Numbers& halves, const Numbers& numbers) {
  const auto is_near = [](double a, double b) { return std::abs(a - b) <= 0x1p-11; };
  return std::ranges::equal(halves, numbers, is_near);
}

bool has_instances(const UsdReadDictionary& values, const InstanceNumbers& expected) {
  return numbers_of(values, "protoIndices") == expected.prototypes &&
         numbers_of(values, "positions") == expected.positions &&
         are_halves_of(numbers_of(values, "orientations"), expected.orientations) &&
         numbers_of(values, "scales") == expected.scales && numbers_of(values, "primvars:feature") == expected.features;
}

void test_instances(const Layer& layer, const std::string& parent, std::span<const bake::InstancedMesh> instanced,
                    CheckResults& results) {
  const UsdReadPrim* instancer = exporters::prim_at(layer.read, parent + "/instances");
  const std::vector<std::string> prototypes =
      instancer == nullptr ? std::vector<std::string>() : targets_of(*instancer, "prototypes");
  InstanceNumbers expected;
  for (std::size_t i = 0; i < instanced.size(); ++i) {
    if (i < prototypes.size()) test_meshes(layer, prototypes[i], instanced[i].primitives, results);
    add_instances(expected, instanced[i], i);
  }
  const UsdReadDictionary none;
  const UsdReadDictionary& values = instancer == nullptr ? none : instancer->values;
  results.usd_same.test_all(
      expected.prototypes.size(), prototypes.size() == instanced.size() && has_instances(values, expected),
      fmt::format("{}: the instances of {} are others than those of the .glb", layer.name, parent));
}

void test_contents(const Layer& layer, const BakedTile& tile, CheckResults& results) {
  for (int i = 0; i < static_cast<int>(bake::Layer::kCount); ++i) {
    const auto which = static_cast<bake::Layer>(i);
    std::vector<bake::Primitive> primitives;
    std::vector<bake::InstancedMesh> instanced;
    std::ranges::copy_if(tile.primitives, std::back_inserter(primitives),
                         [&](const bake::Primitive& p) { return p.layer == which; });
    std::ranges::copy_if(tile.instanced, std::back_inserter(instanced),
                         [&](const bake::InstancedMesh& m) { return layer_of(m) == which; });
    const std::string parent = fmt::format("/tile/{}", name_of(which));
    test_meshes(layer, parent, primitives, results);
    test_instances(layer, parent, instanced, results);
  }
}

// The names of what is assumed of each feature; empty if nothing is assumed.
std::vector<std::string> assumed_texts(const BakedTile& tile) {
  std::vector<std::string> assumed;
  for (const bake::FeatureAttributes& row : tile.attributes)
    assumed.push_back(fmt::format("{}", fmt::join(names_in(row.assumed), " ")));
  if (std::ranges::all_of(assumed, &std::string::empty)) assumed.clear();
  return assumed;
}

void test_facts(const Layer& layer, const BakedTile& tile, const scene::Header& header, CheckResults& results) {
  const UsdReadPrim* root = exporters::prim_at(layer.read, "/tile");
  const UsdReadDictionary none;
  const UsdReadDictionary& data = root == nullptr ? none : root->custom_data;
  const auto test = [&](bool holds, const char* what) {
    results.usd_same.test(holds, fmt::format("{}: {} is another than the tile's", layer.name, what));
  };
  test(is_number(data, "tolerance_m", tile.tolerance_m), "tolerance_m");
  test(is_number(data, "error_m", tile.error_m), "error_m");
  test(is_number(data, "plant_error_m", tile.plant_error_m), "plant_error_m");
  test(numbers_of(data, "origin_m") == numbers_of(tile.origin), "origin_m");
  Numbers ids;
  for (const OsmId& feature : tile.features) ids.push_back(static_cast<double>(feature.id));
  const UsdReadPrim* features = exporters::prim_at(layer.read, "/tile/features");
  test(features != nullptr && numbers_of(features->values, "osm:id") == ids, "the list of OSM ids");
  std::vector<std::string> names;
  for (const bake::FeatureAttributes& row : tile.attributes) names.push_back(row.name);
  if (std::ranges::all_of(names, &std::string::empty)) names.clear();
  test(features != nullptr && texts_of(features->values, "osm:name") == names, "the list of names");
  test(features != nullptr && texts_of(features->values, "osm:assumed") == assumed_texts(tile),
       "the list of assumptions");
  test(texts_of(layer.read.custom_data, "attribution") == std::vector{joined_attributions(header.attributions)},
       "attribution");
  test(layer.read.up_axis == "Z" && layer.read.meters_per_unit == 1 && layer.read.default_prim == "tile",
       "the frame or default prim");
}

// Returns the tile of a level: from its .glb, if the run wrote one that keeps all vertices, else baked again.
Result<BakedTile> expected_tile(const LoadedRun& loaded, bake::PreparedTile& prepared, std::size_t number,
                                const outputs::WrittenTile& level) {
  const auto glb = std::ranges::find_if(loaded.record.tiles, [&](const outputs::WrittenTile& written) {
    return written.tile == level.tile && written.level == level.level;
  });
  const bool keeps_vertices =
      loaded.record.compress == Compression::kNone && !values_of(loaded.record.target).shades_flat;
  if (glb != loaded.record.tiles.end() && keeps_vertices)
    return exporters::read_glb(loaded.folder + "/" + glb->file.name);
  Report ignored;
  return bake::in_world(bake::bake_prepared(prepared, number, 1, ignored), loaded.scene.header);
}

std::string folder_of_file(const std::string& path) { return fs::path(path).parent_path().string(); }

// @param place  The translation that the tile's layer states.
Result<Done> check_usd_level(const LoadedRun& loaded, bake::PreparedTile& prepared, std::size_t number,
                             const outputs::WrittenTile& level, const Numbers& place, CheckResults& results) {
  const std::string path = loaded.folder + "/" + level.file.name, folder = folder_of_file(path);
  const Result<UsdReadLayer> read_layer = read(path);
  if (!read_layer) return read_layer.error();
  const Result<BakedTile> tile = expected_tile(loaded, prepared, number, level);
  if (!tile) return tile.error();
  Layer layer{*read_layer, level.file.name, folder};
  for (const UsdReadPrim& prim : read_layer->prims) layer.paths.insert(prim.path);
  layer.features = tile->features.size();
  check_prims(layer, results);
  test_contents(layer, *tile, results);
  test_facts(layer, *tile, loaded.scene.header, results);
  results.usd_scene.test(
      place == numbers_of(tile->origin),
      fmt::format("{} is not at the origin of {}", exporters::usd_tile_name(level.tile), level.file.name));
  results.usd_same.test(level.triangles == exporters::triangles_of(*tile) && level.error_m == tile->error_m,
                        level.file.name + ": report.json states other triangles or another error");
  return Done{};
}

// ---- scene and tiles ----

using LevelsByTile = std::map<scene::TileKey, std::vector<outputs::WrittenTile>>;

// Returns the payloads of a prim as file names of the run.
std::vector<std::string> payload_names(const UsdReadPrim& prim, const std::string& folder) {
  std::vector<std::string> names;
  for (const std::string& payload : prim.payloads)
    names.push_back((fs::path(folder) / payload).lexically_normal().string());
  return names;
}

void test_variants(const UsdReadPrim& root, const std::string& name, std::span<const outputs::WrittenTile> levels,
                   CheckResults& results) {
  const auto found = root.variants.find("level");
  const std::vector<UsdReadPrim> variants = found == root.variants.end() ? std::vector<UsdReadPrim>() : found->second;
  results.usd_scene.test(variants.size() == levels.size(),
                         fmt::format("{} has {} levels instead of {}", name, variants.size(), levels.size()));
  const auto shown = root.selections.find("level");
  results.usd_scene.test(shown != root.selections.end() && shown->second == "L0", name + " does not show L0");
  for (std::size_t n = 0; n < std::min(variants.size(), levels.size()); ++n) {
    const UsdReadPrim& variant = variants[n];
    results.usd_scene.test(variant.path == fmt::format("L{}", levels[n].level) &&
                               payload_names(variant, exporters::kUsdTileFolder) == std::vector{levels[n].file.name} &&
                               is_number(variant.custom_data, "tolerance_m", levels[n].tolerance_m) &&
                               is_number(variant.custom_data, "error_m", levels[n].error_m),
                           fmt::format("{}: the variant {} is not level {}", name, variant.path, n));
  }
}

Result<Done> check_tile_layer(const LoadedRun& loaded, const std::string& name,
                              std::span<const outputs::WrittenTile> levels, const Numbers& place,
                              CheckResults& results) {
  const Result<UsdReadLayer> layer = read(loaded.folder + "/" + name);
  if (!layer) return layer.error();
  const UsdReadPrim* root = exporters::prim_at(*layer, "/tile");
  results.usd_scene.test(root != nullptr && layer->default_prim == "tile", name + " has no prim \"tile\"");
  if (root == nullptr) return Done{};
  results.usd_scene.test(numbers_of(root->values, "xformOp:translate") == place,
                         name + " is at another place than in the scene");
  results.usd_scene.test(
      texts_of(layer->custom_data, "attribution") == std::vector{joined_attributions(loaded.scene.header.attributions)},
      name + " has another attribution");
  test_variants(*root, name, levels, results);
  return Done{};
}

}  // namespace

Result<CheckResults> check_usd_tile(const LoadedRun& loaded, std::span<const outputs::WrittenTile> levels) {
  const Result<RecipesOfTile> recipes = prepare_tile(loaded, levels);
  if (!recipes) return recipes.error();
  const Result<UsdReadLayer> layer = read(loaded.folder + "/" + exporters::usd_tile_name(levels.front().tile));
  if (!layer) return layer.error();
  const UsdReadPrim* root = exporters::prim_at(*layer, "/tile");
  const Numbers place = root == nullptr ? Numbers{} : numbers_of(root->values, "xformOp:translate");
  CheckResults results;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (const Result<Done> done = check_usd_level(loaded, *recipes->prepared, i, levels[i], place, results); !done)
      return done.error();
  return results;
}

Result<CheckResults> check_usd_scene(const LoadedRun& loaded) {
  CheckResults results;
  const std::string name = exporters::kUsdSceneName;
  const Result<UsdReadLayer> layer = read(loaded.folder + "/" + name);
  if (!layer) return layer.error();
  LevelsByTile tiles;
  for (const outputs::WrittenTile& level : loaded.record.usd) tiles[level.tile].push_back(level);
  std::map<std::string, const UsdReadPrim*> by_payload;
  for (const UsdReadPrim& prim : layer->prims)
    for (const std::string& payload : payload_names(prim, exporters::kUsdFolder)) by_payload[payload] = &prim;
  // the land around the map is not one of the tiles
  if (by_payload.erase(exporters::kUsdSurroundingsName) > 0)
    results.usd_scene.test(bool{read(loaded.folder + "/" + exporters::kUsdSurroundingsName)},
                           std::string(exporters::kUsdSurroundingsName) + " cannot be read");
  results.usd_scene.test(by_payload.size() == tiles.size(), name + " has other tiles than the run");
  results.usd_scene.test(
      texts_of(layer->custom_data, "attribution") == std::vector{joined_attributions(loaded.scene.header.attributions)},
      name + " has another attribution");
  for (const auto& [tile, levels] : tiles) {
    const std::string file = exporters::usd_tile_name(tile);
    const auto prim = by_payload.find(file);
    results.usd_scene.test(prim != by_payload.end(), fmt::format("{} has no payload {}", name, file));
    if (prim == by_payload.end()) continue;
    results.usd_scene.test(numbers_of(prim->second->values, "extentsHint").size() == 6, file + " has no bounds");
    const Numbers& place = numbers_of(prim->second->values, "xformOp:translate");
    if (const Result<Done> done = check_tile_layer(loaded, file, levels, place, results); !done) return done.error();
  }
  return results;
}

}  // namespace citykiln::verify
