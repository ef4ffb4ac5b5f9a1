#include "compiler/verify/check_tileset.h"

#include <fmt/format.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "exporters/file.h"
#include "exporters/gltf/glb.h"
#include "exporters/joined_attributions.h"
#include "exporters/rotated.h"
#include "exporters/run_files.h"
#include "exporters/tiles3d/read_tileset.h"

namespace citykiln::verify {
namespace {

using Json = nlohmann::json;
using exporters::OrientedBox;
using exporters::TilesetTile;

// Allowed distance of a vertex outside its box, for single precision on the coordinates of a tile.
constexpr double kSlack_m = 0.002;

// The distance of a point outside a box, along its axes; 0 inside.
double outside_m(const OrientedBox& box, Vec3 p) {
  double farthest_m = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along_m = dot(box.axes[i], p);
    farthest_m = std::max({farthest_m, box.low[i] - along_m, along_m - box.high[i]});
  }
  return farthest_m;
}

double corners_outside_m(const OrientedBox& outer, const OrientedBox& inner) {
  double farthest_m = 0;
  for (unsigned i = 0; i < 8; ++i) farthest_m = std::max(farthest_m, outside_m(outer, inner.corner(i)));
  return farthest_m;
}

// ---- tilesets ----

ContentReference reference_of(const TilesetTile& tile) { return {tile.content, tile.box, tile.error_m}; }

/// Walks the tiles of one file: compares each with its children, and lists contents. Returns the number of tiles.
std::uint64_t walk_tiles(const TilesetTile& tile, const std::string& name, CheckResults& results,
                         CheckedTileset& read) {
  if (!tile.content.empty()) (is_external(tile) ? read.external : read.contents).push_back(reference_of(tile));
  std::uint64_t tiles = 1;
  for (const TilesetTile& child : tile.children) {
    const double out_m = corners_outside_m(tile.box, child.box);
    tiles += walk_tiles(child, name, results, read);
    results.tileset_boxes.test(out_m <= kSlack_m, fmt::format("{}: a child's volume is {} m outside", name, out_m));
    results.tileset_errors.test(child.error_m < tile.error_m,
                                fmt::format("{}: {} m below {} m", name, child.error_m, tile.error_m));
  }
  return tiles;
}

/// Reads a tileset and all tilesets that it refers to, each once.
class Reader {
 public:
  Reader(std::string folder, CheckResults& results) : folder_(std::move(folder)), results_(results) {}

  CheckedTileset read(const std::string& name) {
    const auto bytes = exporters::read_file(folder_ + name);
    results_.tileset.test(static_cast<bool>(bytes), name + " cannot be read");
    if (!bytes) return {};
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    CheckedTileset all = check_tileset_file(text, name, results_);
    for (const ContentReference& external : std::exchange(all.external, {})) add(external, all);
    return all;
  }

 private:
  void add(const ContentReference& external, CheckedTileset& all) {
    const bool is_new = read_.insert(external.uri).second;
    results_.tileset.test(is_new, external.uri + " is named twice");
    if (!is_new) return;
    CheckedTileset inner = read(external.uri);
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

/// Converts places from the frame of the tileset to the plane, by GeographicLib, or from the inside of a cylinder.
class Unbend {
 public:
  /// @param near_y_m  A place of the tile, which tells turns of a cylinder apart.
  Unbend(const scene::Header& header, double near_y_m)
      : local_(header.origin.lat_deg, header.origin.lon_deg, 0),
        plane_(header.origin),
        cylinder_(scene::cylinder_of(header)),
        near_y_m_(near_y_m) {}

  /// Returns plane metres, with the height above the ellipsoid as z, or that above the cylinder's ground.
  Vec3 operator()(Vec3 p) const {
    if (cylinder_) return map::flattened(*cylinder_, p, near_y_m_);
    LonLat place;
    double height_m = 0;
    local_.Reverse(p.x, p.y, p.z, place.lat_deg, place.lon_deg, height_m);
    return at_height(plane_.forward(place), height_m);
  }

 private:
  GeographicLib::LocalCartesian local_;
  map::Plane plane_;
  std::optional<map::Cylinder> cylinder_;
  double near_y_m_;
};

// The largest difference between the root's transform and none, which worlds inside of a cylinder have.
double off_identity(const std::vector<double>& transform) {
  if (transform.size() != 16) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < 16; ++i) largest = std::max(largest, std::abs(transform[i] - (i % 5 == 0 ? 1 : 0)));
  return largest;
}

// The largest distance between the root's transform and the local frame at the origin, at the ends of axes of 100 km.
double transform_error_m(LonLat origin, const std::vector<double>& transform) {
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

/// A terrain vertex on a side of a tile.
struct SideVertex {
  double along_m;   ///< The distance along the side.
  double height_m;  ///< Above the ellipsoid, or above the ground of a cylinder.
  Vec3 at;          ///< In the frame of the run.
};
using Side = std::vector<SideVertex>;

/// Takes the vertices of a sorted side from `next` on that follow within `kPlace_m` of `end_m`, which grows with them.
void take_place(const Side& side, std::size_t& next, double& end_m, std::set<std::pair<double, Vec3>>& place) {
  constexpr double kPlace_m = 0.003;  // vertices above each other are rounded apart by less
  for (; next < side.size() && side[next].along_m <= end_m + kPlace_m; ++next) {
    place.emplace(side[next].height_m, side[next].at);
    end_m = std::max(end_m, side[next].along_m);
  }
}

/// True if two sorted sides have vertices at the same places, and share at each place the lower of their highest
/// vertices. The other side may have a higher one: a pavement that touches the border in a point from one side ends
/// there in a kerb.
bool do_meet(const Side& a, const Side& b) {
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    double end_m = std::min(i < a.size() ? a[i].along_m : HUGE_VAL, j < b.size() ? b[j].along_m : HUGE_VAL);
    std::set<std::pair<double, Vec3>> of_a, of_b;
    for (std::size_t taken = i + j + 1; taken != i + j;) {
      taken = i + j;
      take_place(a, i, end_m, of_a), take_place(b, j, end_m, of_b);
    }
    if (of_a.empty() || of_b.empty()) return false;
    const auto lower = std::min(*of_a.rbegin(), *of_b.rbegin());
    if (!of_a.contains(lower) || !of_b.contains(lower)) return false;
  }
  return true;
}

/// The results for a content, and the data needed to compare its borders.
struct CheckedContent {
  CheckResults results;
  scene::TileKey tile;
  double tolerance_m = 0;
  std::array<Side, 4> sides;  ///< West, east, south, north; sorted along each side.
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

// The largest distance of a vertex of a tile outside a box.
double vertices_outside_m(const OrientedBox& box, const bake::BakedTile& tile) {
  double farthest_m = 0;
  for (const bake::Primitive& p : tile.primitives)
    for (const bake::Float3& at : p.positions)
      farthest_m = std::max(farthest_m, outside_m(box, tile.origin + bake::widened(at)));
  for (const bake::InstancedMesh& mesh : tile.instanced)
    for (std::size_t i = 0; i < mesh.translations.size(); ++i)
      for (const bake::Primitive& p : mesh.primitives)
        for (const bake::Float3& at : p.positions)
          farthest_m =
              std::max(farthest_m,
                       outside_m(box, tile.origin + bake::widened(mesh.translations[i]) +
                                          exporters::rotated(mesh.rotations[i], bake::widened(at) * mesh.scales[i])));
  return farthest_m;
}

void find_sides(const bake::BakedTile& tile, const scene::Header& header, CheckedContent& content) {
  constexpr double kRounded_m = 0.0008;  // a vertex is rounded to 2^-10 m, and moved by at most 0.7 of it in plan
  const bool is_inside = scene::cylinder_of(header).has_value();
  // along the axis of a cylinder vertices stay; high above its ground a step is a longer way around it
  const double across_m = is_inside ? 1e-6 : kRounded_m, along_m = is_inside ? 2 * kRounded_m : kRounded_m;
  const double on_side_m[] = {across_m, across_m, along_m, along_m};
  const Vec2 low = Vec2{static_cast<double>(tile.tile.x), static_cast<double>(tile.tile.y)} * header.tile_m,
             high = low + Vec2{header.tile_m, header.tile_m};
  const Unbend unbend(header, (low.y + high.y) / 2);
  for (const bake::Primitive& primitive : tile.primitives) {
    if (!is_terrain(primitive)) continue;
    for (const bake::Float3& at : primitive.positions) {
      const Vec3 there = tile.origin + bake::widened(at);
      const Vec3 p = unbend(there);
      const double away_m[] = {p.x - low.x, p.x - high.x, p.y - low.y, p.y - high.y};
      for (std::size_t side = 0; side < 4; ++side)
        if (std::abs(away_m[side]) <= on_side_m[side])
          content.sides[side].push_back({side < 2 ? p.y : p.x, p.z, there});
    }
  }
  for (Side& side : content.sides) std::ranges::sort(side, {}, &SideVertex::along_m);
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
  results.tileset.test(copyright_of(*bytes) == exporters::joined_attributions(run.scene.header.attributions),
                       reference.uri + " has another attribution");
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

CheckedTileset check_tileset_file(const std::string& json, const std::string& name, CheckResults& results) {
  const Result<exporters::ReadTileset> file = exporters::decode_tileset(json, name);
  if (!file) {
    results.tileset.test(false, to_string(file.error()));
    return {};
  }
  CheckedTileset read{.root = reference_of(file->root), .transform = file->transform, .attribution = file->attribution};
  results.tileset.test_all(walk_tiles(file->root, name, results, read), !read.attribution.empty(),
                           name + ": no attribution");
  results.tileset_errors.test(file->error_m > file->root.error_m,
                              name + ": the tileset's geometricError is not above its root's");
  return read;
}

void check_tileset(const LoadedRun& run, int threads, CheckResults& results) {
  const std::string folder = run.folder + "/" + exporters::kTilesetFolder + "/";
  if (!std::filesystem::exists(folder + exporters::kTilesetName)) return;
  const CheckedTileset read = Reader(folder, results).read(exporters::kTilesetName);
  const bool is_inside = scene::cylinder_of(run.scene.header).has_value();
  const double out_m =
      is_inside ? off_identity(read.transform) : transform_error_m(run.scene.header.origin, read.transform);
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
