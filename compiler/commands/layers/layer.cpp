#include "compiler/commands/layers/layer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/geometry/polygons/clip_polygon.h"

namespace citykiln::commands {

void Properties::add_json(std::string_view name, std::string_view value) {
  json_ += fmt::format(R"(,"{}":{})", name, value);
}

void Properties::add(std::string_view name, std::string_view value) {
  if (!value.empty()) add_json(name, nlohmann::json(value).dump());
}

void Properties::add(std::string_view name, double value) { add_json(name, fmt::format("{}", value)); }

void Properties::add(std::string_view name, bool value) {
  if (value) add_json(name, "true");
}

void Properties::add(std::string_view name, const std::vector<std::string>& values) {
  add_json(name, nlohmann::json(values).dump());
}

std::vector<Vec3> flat(std::span<const Vec2> points) {
  std::vector<Vec3> line;
  for (const Vec2 p : points) line.push_back({p.x, p.y, 0});
  return line;
}

std::vector<std::vector<std::vector<Vec3>>> flat(std::span<const Polygon> polygons) {
  std::vector<std::vector<std::vector<Vec3>>> parts;
  for (const Polygon& polygon : polygons) {
    auto& rings = parts.emplace_back();
    for (const Ring& ring : copied_rings(polygon)) rings.push_back(flat(ring));
  }
  return parts;
}

std::string_view layer_names() { return "roads, junctions, areas, buildings or plants"; }

}  // namespace citykiln::commands
