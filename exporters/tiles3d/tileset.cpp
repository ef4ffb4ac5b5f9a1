#include "exporters/tiles3d/tileset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

#include "compiler/contract/system/program_version.h"
#include "exporters/joined_attributions.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kSuffix = ".json";

std::string path_in_run(std::string_view name) { return fmt::format("{}/{}", kTilesetFolder, name); }

std::size_t tiles_of(const TilesetTile& tile) {
  std::size_t count = 1;
  for (const TilesetTile& child : tile.children) count += tiles_of(child);
  return count;
}

OrderedJson extras_of(const TilesetTile& tile) {
  return {{"tolerance_m", tile.tolerance_m}, {"error_m", tile.error_m}};
}

OrderedJson json_of(const TilesetTile& tile) {
  OrderedJson json = {{"boundingVolume", {{"box", numbers_of(tile.box)}}}, {"geometricError", tile.error_m}};
  if (!tile.content.empty()) json["content"] = {{"uri", tile.content}};
  if (!tile.content.empty() && !is_external(tile)) json["extras"] = extras_of(tile);
  for (const TilesetTile& child : tile.children) {
    assert(child.error_m < tile.error_m);
    json["children"].push_back(json_of(child));
  }
  return json;
}

OrderedJson asset_of(const TilesetFacts& facts) {
  OrderedJson credits = OrderedJson::array();
  for (const std::string& credit : facts.attributions) credits.push_back({{"html", credit}, {"showOnScreen", true}});
  return {{"version", "1.1"},
          {"generator", kProgramVersion},
          {"copyright", joined_attributions(facts.attributions)},
          {"extras", {{"copyright", joined_attributions(facts.attributions)}, {"cesium", {{"credits", credits}}}}}};
}

OrderedJson property(const char* description, const char* type) {
  if (std::string_view(type) == "STRING") return {{"type", type}, {"description", description}};
  return {{"type", "SCALAR"}, {"componentType", type}, {"description", description}};
}

void add_metadata_inside(OrderedJson& json, const TilesetFacts& facts) {
  OrderedJson properties = {
      {"attribution", property("sources of the data", "STRING")},
      {"cylinder_radius_m", property("radius of the cylinder around the x axis that the world is in", "FLOAT64")}};
  json["schema"] = {{"id", "citykiln_tileset"}, {"classes", {{"tileset", {{"properties", properties}}}}}};
  json["metadata"] = {
      {"class", "tileset"},
      {"properties",
       {{"attribution", joined_attributions(facts.attributions)}, {"cylinder_radius_m", facts.cylinder_radius_m}}}};
}

void add_metadata(OrderedJson& json, const TilesetFacts& facts) {
  if (facts.cylinder_radius_m > 0) return add_metadata_inside(json, facts);
  const bool has_geoid = !facts.geoid.empty();
  OrderedJson properties = {
      {"attribution", property("sources of the data", "STRING")},
      {"origin_lon_deg", property("longitude of the origin of the plane and of the root's frame", "FLOAT64")},
      {"origin_lat_deg", property("latitude of the same", "FLOAT64")},
      {"heights", property("what heights above the ellipsoid were made from", "STRING")},
      {"geoid_height_m",
       property("height of the geoid above the ellipsoid at the origin, which was added", "FLOAT64")}};
  json["schema"] = {{"id", "citykiln_tileset"}, {"classes", {{"tileset", {{"properties", properties}}}}}};
  json["metadata"] = {
      {"class", "tileset"},
      {"properties",
       {{"attribution", joined_attributions(facts.attributions)},
        {"origin_lon_deg", facts.origin.lon_deg},
        {"origin_lat_deg", facts.origin.lat_deg},
        {"heights", has_geoid ? "heights above sea level, and the geoid's: " + facts.geoid
                              : std::string("heights above sea level; no height of the geoid was given")},
        {"geoid_height_m", facts.geoid_height_m}}}};
}

double diagonal_m(const OrientedBox& box) { return length(box.corner(7) - box.corner(0)); }

std::string tileset_text(const TilesetTile& root, const TilesetFacts& facts, bool is_outermost) {
  OrderedJson json = {{"asset", asset_of(facts)}};
  if (is_outermost) add_metadata(json, facts);
  json["geometricError"] = std::max(diagonal_m(root.box), 2 * root.error_m);
  json["root"] = json_of(root);
  json["root"]["refine"] = "REPLACE";
  if (is_outermost) json["root"]["transform"] = facts.to_earth;
  return json.dump() + "\n";
}

/// Moves subtrees into files of their own, the deepest first, until each file has at most kMostTilesInFile tiles.
/// Chains of levels stay whole.
class Divider {
 public:
  explicit Divider(const TilesetFacts& facts) : facts_(facts) {}

  void divide(TilesetTile& tile) {
    for (TilesetTile& child : tile.children) divide(child);
    while (tiles_of(tile) > kMostTilesInFile) {
      const auto largest = std::ranges::max_element(tile.children, {}, tiles_of);
      if (largest == tile.children.end() || largest->children.empty()) return;
      move_out(*largest);
    }
  }

  std::vector<TilesetFile> files;

 private:
  void move_out(TilesetTile& tile) {
    const std::string name = fmt::format("tileset_{}{}", files.size() + 1, kSuffix);
    files.push_back({path_in_run(name), tileset_text(tile, facts_, false)});
    tile.content = name, tile.children.clear();
  }

  const TilesetFacts& facts_;
};

}  // namespace

bool is_external(const TilesetTile& tile) { return tile.content.ends_with(kSuffix); }

std::vector<TilesetFile> encode_tileset(TilesetTile root, const TilesetFacts& facts) {
  Divider divider(facts);
  divider.divide(root);
  divider.files.push_back({path_in_run(kTilesetName), tileset_text(root, facts, true)});
  return std::move(divider.files);
}

}  // namespace citykiln::exporters
