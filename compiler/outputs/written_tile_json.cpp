#include "compiler/outputs/written_tile_json.h"

#include <nlohmann/json.hpp>

namespace citykiln::outputs {

nlohmann::ordered_json json_of(const WrittenTile& tile) {
  return {{"file", tile.file.name},  {"bytes", tile.file.bytes},    {"x", tile.tile.x},
          {"y", tile.tile.y},        {"level", tile.level},         {"tolerance_m", tile.tolerance_m},
          {"error_m", tile.error_m}, {"triangles", tile.triangles}, {"instances", tile.instances}};
}

WrittenTile parse_written_tile(const nlohmann::ordered_json& json) {
  return {.file = {json.at("file"), json.at("bytes")},
          .tile = {json.at("x"), json.at("y")},
          .level = json.at("level"),
          .tolerance_m = json.at("tolerance_m"),
          .error_m = json.at("error_m"),
          .triangles = json.at("triangles"),
          .instances = json.at("instances")};
}

}  // namespace citykiln::outputs
