#include "compiler/commands/view/read_line_string.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace citykiln::commands {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMostBytes = 64'000'000;

// The member of an object; null if it has none, or is no object.
const json& member(const json& object, const char* name) {
  static const json kNull;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() ? *found : kNull;
}

// The coordinates of the first LineString; null if there is none.
const json& coordinates_in(const json& object, int depth = 0) {
  static const json kNull;
  if (member(object, "type") == "LineString") return member(object, "coordinates");
  if (depth == 2) return kNull;
  if (const json& geometry = member(object, "geometry"); geometry.is_object())
    return coordinates_in(geometry, depth + 1);
  for (const json& feature : member(object, "features"))
    if (const json& coordinates = coordinates_in(feature, depth + 1); !coordinates.is_null()) return coordinates;
  return kNull;
}

std::optional<LonLatHeight> place_in(const json& position) {
  if (!position.is_array() || position.size() < 2) return std::nullopt;
  for (std::size_t i = 0; i < std::min<std::size_t>(position.size(), 3); ++i)
    if (!position[i].is_number() || !std::isfinite(position[i].get<double>())) return std::nullopt;
  LonLatHeight place{position[0].get<double>(), position[1].get<double>()};
  if (position.size() > 2) place.height_m = position[2].get<double>();
  return std::abs(place.lat_deg) <= 90 && std::abs(place.lon_deg) <= 360 ? std::optional(place) : std::nullopt;
}

}  // namespace

Result<std::vector<LonLatHeight>> read_line_string(const std::string& path) {
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(path, problem);
  std::ifstream in(path, std::ios::binary);
  if (problem || !in) return Error{path, "cannot be read"};
  if (bytes > kMostBytes) return Error{path, "is larger than 64 MB; expected GeoJSON with a LineString"};
  const json document = json::parse(in, nullptr, false);
  if (document.is_discarded()) return Error{path, "is no JSON; expected GeoJSON with a LineString"};
  const json& coordinates = coordinates_in(document);
  if (!coordinates.is_array()) return Error{path, "has no LineString"};
  std::vector<LonLatHeight> line;
  for (const json& position : coordinates) {
    const auto place = place_in(position);
    if (!place)
      return Error{path, "position " + std::to_string(line.size() + 1) +
                             " of the LineString: expected longitude and latitude in degrees"};
    line.push_back(*place);
  }
  if (line.size() < 2) return Error{path, "has a LineString of fewer than 2 positions"};
  return line;
}

}  // namespace citykiln::commands
