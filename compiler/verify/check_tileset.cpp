#include "compiler/verify/check_tileset.h"

#include <fmt/format.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "compiler/contract/for_each_slot.h"
#include "exporters/file.h"
#include "exporters/gltf/glb.h"
#include "exporters/run_files.h"

namespace citykiln::verify {
namespace {

using Json = nlohmann::json;
using Box12 = std::array<double, 12>;

// Allowed distance of a vertex outside its box, for single precision on the coordinates of a tile.
constexpr double kSlack_m = 0.002;
// An upper bound of the depth of trees that runs write: a tree over the whole Earth has 32 levels above its tiles.
constexpr int kMostDepth = 64;

Vec3 axis(const Box12& box, std::size_t i) { return {box[3 + 3 * i], box[4 + 3 * i], box[5 + 3 * i]}; }
Vec3 centre(const Box12& box) { return {box[0], box[1], box[2]}; }

// The distance of a point outside a box, along its axes; 0 inside.
double outside_m(const Box12& box, Vec3 p) {
  double farthest_m = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double half_m = length(axis(box, i));
    farthest_m = std::max(farthest_m, std::abs(dot(unit(axis(box, i)), p - centre(box))) - half_m);
  }
  return farthest_m;
}

double corners_outside_m(const Box12& outer, const Box12& inner) {
  double farthest_m = 0;
  for (unsigned i = 0; i < 8; ++i) {
    Vec3 corner = centre(inner);
    for (std::size_t a = 0; a < 3; ++a) corner = corner + axis(inner, a) * ((i >> a) % 2 == 0 ? -1.0 : 1.0);
    farthest_m = std::max(farthest_m, outside_m(outer, corner));
  }
  return farthest_m;
}

// ---- tilesets ----

/// Visits the tiles of one file. Throws Json::exception if a value has another type than expected.
class Walk {
 public:
  Walk(const std::string& name, CheckResults& results, ReadTileset& read)
      : name_(name), results_(results), read_(read) {}

  ContentReference visit(const Json& tile, int depth) {
    ContentReference own{.uri = {}, .box = box_of(tile), .geometric_error_m = tile.at("geometricError").get<double>()};
    results_.tileset.test(
        own.geometric_error_m >= 0 && (depth > 0 || tile.at("refine") == "REPLACE") && depth < kMostDepth,
        name_ + ": a tile's geometricError, refine or depth");
    if (tile.contains("content")) add_content(tile.at("content").at("uri").get<std::string>(), own);
    if (!tile.contains("children") || depth >= kMostDepth) return own;
    results_.tileset.test(!tile.at("children").empty(), name_ + ": children without a tile");
    for (const Json& child : tile.at("children")) compare(own, visit(child, depth + 1));
    return own;
  }

 private:
  static Box12 box_of(const Json& tile) {
    const auto numbers = tile.at("boundingVolume").at("box").get<std::vector<double>>();
    if (numbers.size() != 12) throw Json::other_error::create(500, "a box without twelve numbers", nullptr);
    Box12 box{};
    std::ranges::copy(numbers, box.begin());
    return box;
  }

  void add_content(const std::string& uri, const ContentReference& tile) {
    // names stay inside the folder
    const bool is_name = !uri.empty() && uri.find("..") == std::string::npos && uri.front() != '/';
    results_.tileset.test(is_name && (uri.ends_with(".glb") || uri.ends_with(".json")), name_ + ": content " + uri);
    ContentReference content = tile;
    content.uri = uri;
    (uri.ends_with(".json") ? read_.external : read_.contents).push_back(std::move(content));
  }

  void compare(const ContentReference& parent, const ContentReference& child) {
    const double out_m = corners_outside_m(parent.box, child.box);
    results_.tileset_boxes.test(out_m <= kSlack_m, fmt::format("{}: a child's volume is {} m outside", name_, out_m));
    results_.tileset_errors.test(
        child.geometric_error_m < parent.geometric_error_m,
        fmt::format("{}: {} m below {} m", name_, child.geometric_error_m, parent.geometric_error_m));
  }

  const std::string& name_;
  CheckResults& results_;
  ReadTileset& read_;
};

/// Reads a tileset and all tilesets that it refers to, each once.
class Reader {
 public:
  Reader(std::string folder, CheckResults& results) : folder_(std::move(folder)), results_(results) {}

  ReadTileset read(const std::string& name) {
    const auto bytes = exporters::read_file(folder_ + name);
    results_.tileset.test(static_cast<bool>(bytes), name + " cannot be read");
    if (!bytes) return {};
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    ReadTileset all = read_tileset(text, name, results_);
    for (const ContentReference& external : std::exchange(all.external, {})) add(external, all);
    return all;
  }

 private:
  void add(const ContentReference& external, ReadTileset& all) {
    const bool is_new = read_.insert(external.uri).second;
    results_.tileset.test(is_new, external.uri + " is named twice");
    if (!is_new) return;
    ReadTileset inner = read(external.uri);
    results_.tileset_boxes.test(corners_outside_m(external.box, inner.root.box) <= kSlack_m,
                                external.uri + " is outside of the tile that names it");
    // the tile that names a tileset stands for its root
    results_.tileset_errors.test(inner.root.geometric_error_m <= external.geometric_error_m,
                                 external.uri + " has a larger error than the tile that names it");
    std::ranges::move(inner.contents, std::back_inserter(all.contents));
  }

  std::string folder_;
  CheckResults& results_;
  std::set<std::string> read_;
};

// ---- places on the globe ----

/// Converts places from the frame of the tileset to the plane, by GeographicLib.
class Unbend {
 public:
  explicit Unbend(map::LonLat origin) : local_(origin.lat_deg, origin.lon_deg, 0), plane_(origin) {}

  /// Returns plane metres, with the height above the ellipsoid as z.
  Vec3 operator()(Vec3 p) const {
    map::LonLat place;
    double height_m = 0;
    local_.Reverse(p.x, p.y, p.z, place.lat_deg, place.lon_deg, height_m);
    return at_height(plane_.forward(place), height_m);
  }

 private:
  GeographicLib::LocalCartesian local_;
  map::Plane plane_;
};

// The largest distance between the root's transform and the local frame at the origin, at the ends of axes of 100 km.
double transform_error_m(map::LonLat origin, const std::vector<double>& transform) {
  if (transform.size() != 16) return HUGE_VAL;
  const GeographicLib::LocalCartesian local(origin.lat_deg, origin.lon_deg, 0);
  double farthest_m = 0;
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1e5, 0, 0}, Vec3{0, 1e5, 0}, Vec3{0, 0, 1e5}}) {
    double lat = 0, lon = 0, height_m = 0;
    Vec3 earth;
    local.Reverse(p.x, p.y, p.z, lat, lon, height_m);
    GeographicLib::Geocentric::WGS84().Forward(lat, lon, height_m, earth.x, earth.y, earth.z);
    const auto& m = transform;
    const Vec3 found{m[0] * p.x + m[4] * p.y + m[8] * p.z + m[12], m[1] * p.x + m[5] * p.y + m[9] * p.z + m[13],
                     m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14]};
    farthest_m = std::max(farthest_m, length(found - earth));
  }
  return farthest_m;
}

// ---- contents ----

/// The terrain vertices on a side of a tile, by the distance along the side in centimetres. Each has its height above
/// the ellipsoid.
using Side = std::map<std::int64_t, std::set<std::pair<double, Vec3>>>;

/// True if two sides have vertices at the same places, and share at each place the lower of their highest vertices. The
/// other side may have a higher one: a pavement that touches the border in a point from one side ends there in a kerb.
bool do_meet(const Side& a, const Side& b) {
  return std::ranges::equal(a, b, [](const auto& of_a, const auto& of_b) {
    const auto lower = std::min(*of_a.second.rbegin(), *of_b.second.rbegin());
    return of_a.first == of_b.first && of_a.second.contains(lower) && of_b.second.contains(lower);
  });
}

/// The results for a content, and the data needed to compare its borders.
struct CheckedContent {
  CheckResults results;
  scene::TileKey tile;
  double tolerance_m = 0;
  std::array<Side, 4> sides;  ///< West, east, south, north; in the frame of the run.
};

// Returns asset.copyright of a .glb, whose first chunk is JSON.
std::string copyright_of(const std::vector<std::byte>& glb) {
  if (glb.size() < 20) return "";
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, sizeof size);
  if (size > glb.size() - 20) return "";
  const char* text = reinterpret_cast<const char*>(glb.data() + 20);
  const Json json = Json::parse(text, text + size, nullptr, false);
  const Json asset = json.is_object() ? json.value("asset", Json::object()) : Json::object();
  return asset.is_object() && asset.contains("copyright") && asset["copyright"].is_string()
             ? asset["copyright"].get<std::string>()
             : "";
}

Vec3 turned(const bake::Float4& q, Vec3 v) {
  const Vec3 u{q[0], q[1], q[2]};
  const Vec3 t = cross(u, v) * 2;
  return v + t * q[3] + cross(u, t);
}

// The largest distance of a vertex of a tile outside a box.
double vertices_outside_m(const Box12& box, const bake::BakedTile& tile) {
  double farthest_m = 0;
  for (const bake::Primitive& p : tile.primitives)
    for (const bake::Float3& at : p.positions)
      farthest_m = std::max(farthest_m, outside_m(box, tile.origin + bake::widened(at)));
  for (const bake::InstancedMesh& mesh : tile.instanced)
    for (std::size_t i = 0; i < mesh.translations.size(); ++i)
      for (const bake::Primitive& p : mesh.primitives)
        for (const bake::Float3& at : p.positions)
          farthest_m =
              std::max(farthest_m, outside_m(box, tile.origin + bake::widened(mesh.translations[i]) +
                                                      turned(mesh.rotations[i], bake::widened(at) * mesh.scales[i])));
  return farthest_m;
}

void find_sides(const bake::BakedTile& tile, const scene::Header& header, CheckedContent& content) {
  constexpr double kOnSide_m = 0.0008;  // a vertex is rounded to 2^-10 m, and moved by at most 0.7 of it in plan
  const Unbend unbend(header.origin);
  const Vec2 low = Vec2{static_cast<double>(tile.tile.x), static_cast<double>(tile.tile.y)} * header.tile_m,
             high = low + Vec2{header.tile_m, header.tile_m};
  for (const bake::Primitive& primitive : tile.primitives) {
    if (!is_terrain(primitive)) continue;
    for (const bake::Float3& at : primitive.positions) {
      const Vec3 there = tile.origin + bake::widened(at);
      const Vec3 p = unbend(there);
      const double away_m[] = {p.x - low.x, p.x - high.x, p.y - low.y, p.y - high.y};
      for (std::size_t side = 0; side < 4; ++side)
        if (std::abs(away_m[side]) <= kOnSide_m) {
          const auto along_cm = static_cast<std::int64_t>(std::floor((side < 2 ? p.y : p.x) * 100));
          content.sides[side][along_cm].emplace(p.z, there);
        }
    }
  }
}

CheckedContent check_content(const LoadedRun& run, const ContentReference& reference) {
  CheckedContent content;
  CheckResults& results = content.results;
  const std::string path = run.folder + "/" + exporters::kTilesetFolder + "/" + reference.uri;
  const auto bytes = exporters::read_file(path);
  const Result<bake::BakedTile> tile =
      bytes ? exporters::decode_glb(*bytes, reference.uri) : Result<bake::BakedTile>(bytes.error());
  results.tileset.test(static_cast<bool>(tile), tile ? "" : to_string(tile.error()));
  if (!tile) return content;
  std::string credits;
  for (const std::string& credit : run.scene.header.attributions) credits += (credits.empty() ? "" : "; ") + credit;
  results.tileset.test(copyright_of(*bytes) == credits, reference.uri + " has another attribution");
  results.tileset.test(!tile->primitives.empty(), reference.uri + " has no meshes");
  const double out_m = vertices_outside_m(reference.box, *tile);
  results.tileset_boxes.test(out_m <= kSlack_m, fmt::format("{}: a vertex is {} m outside", reference.uri, out_m));
  results.tileset_errors.test(
      tile->error_m <= reference.geometric_error_m,
      fmt::format("{}: error {} m, geometricError {} m", reference.uri, tile->error_m, reference.geometric_error_m));
  content.tile = tile->tile, content.tolerance_m = tile->tolerance_m;
  if (reference.uri.find("_L") != std::string::npos) find_sides(*tile, run.scene.header, content);
  return content;
}

void check_seams(const std::vector<CheckedContent>& contents, CheckResults& results) {
  std::map<std::pair<double, scene::TileKey>, const CheckedContent*> by_tile;
  for (const CheckedContent& content : contents)
    if (!content.sides[0].empty() || !content.sides[1].empty() || !content.sides[2].empty() ||
        !content.sides[3].empty())
      by_tile[{content.tolerance_m, content.tile}] = &content;
  for (const auto& entry : by_tile) {
    // clang before 16 cannot capture structured bindings
    const CheckedContent& own = *entry.second;
    const auto compare = [&](scene::TileKey other, std::size_t side, std::size_t opposite) {
      const auto neighbour = by_tile.find({own.tolerance_m, other});
      if (neighbour == by_tile.end()) return;
      results.tileset_seams.test(
          do_meet(own.sides[side], neighbour->second->sides[opposite]),
          fmt::format("{} and {} at {} m", to_string(own.tile), to_string(other), own.tolerance_m));
    };
    compare({own.tile.x + 1, own.tile.y}, 1, 0);
    compare({own.tile.x, own.tile.y + 1}, 3, 2);
  }
}

}  // namespace

ReadTileset read_tileset(const std::string& json, const std::string& name, CheckResults& results) {
  ReadTileset read;
  try {
    const Json tileset = Json::parse(json);
    const Json& asset = tileset.at("asset");
    results.tileset.test(asset.at("version") == "1.1", name + ": asset.version is not 1.1");
    read.attribution = asset.at("extras").at("copyright").get<std::string>();
    const Json& root = tileset.at("root");
    if (root.contains("transform")) read.transform = root.at("transform").get<std::vector<double>>();
    read.root = Walk(name, results, read).visit(root, 0);
    results.tileset_errors.test(tileset.at("geometricError").get<double>() > read.root.geometric_error_m,
                                name + ": the tileset's geometricError is not above its root's");
  } catch (const Json::exception& wrong) {
    results.tileset.test(false, fmt::format("{}: {}", name, wrong.what()));
  }
  return read;
}

void check_tileset(const LoadedRun& run, int threads, CheckResults& results) {
  const std::string folder = run.folder + "/" + exporters::kTilesetFolder + "/";
  if (!std::filesystem::exists(folder + exporters::kTilesetName)) return;
  const ReadTileset read = Reader(folder, results).read(exporters::kTilesetName);
  const double out_m = transform_error_m(run.scene.header.origin, read.transform);
  results.tileset.test(out_m < 0.001, fmt::format("the root's transform is {} m from the frame of the origin", out_m));
  for (const std::string& credit : run.scene.header.attributions)
    results.tileset.test(read.attribution.find(credit) != std::string::npos,
                         std::string(exporters::kTilesetName) + " does not name " + credit);
  const auto contents = for_each_slot<CheckedContent>(
      read.contents.size(), threads, [&](std::size_t i) { return check_content(run, read.contents[i]); });
  for (const CheckedContent& content : contents) add(results, content.results);
  check_seams(contents, results);
}

}  // namespace citykiln::verify
