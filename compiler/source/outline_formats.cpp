#include "compiler/source/outline_formats.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/contract/texts/parse.h"
#include "compiler/source/read_texts.h"

namespace citykiln::source {
namespace {

using nlohmann::json;

std::optional<LonLat> place_of(const json& point) {
  if (!point.is_array() || point.size() < 2 || !point[0].is_number() || !point[1].is_number()) return std::nullopt;
  return LonLat{point[0].get<double>(), point[1].get<double>()};
}

Result<LonLatRing> ring_of_json(const json& points, const std::string& where) {
  if (!points.is_array()) return Error{where, "expected a ring, an array of positions"};
  LonLatRing ring;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<LonLat> at = place_of(points[i]);
    if (!at) return Error{where, fmt::format("expected [longitude, latitude] as point {}", i + 1)};
    ring.push_back(*at);
  }
  if (ring.size() < 2 || ring.front() != ring.back())
    return Error{where, "is not closed: the last position of a ring repeats the first"};
  ring.pop_back();
  return ring;
}

Result<Done> add_polygon_of_json(const json& rings, Outline& outline) {
  const std::string where = fmt::format("{}: polygon {}", outline.where, outline.polygons.size() + 1);
  if (!rings.is_array() || rings.empty()) return Error{where, "expected rings, an array that is not empty"};
  LonLatPolygon polygon;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    Result<LonLatRing> ring = ring_of_json(rings[i], i == 0 ? where : fmt::format("{}, hole {}", where, i));
    if (!ring) return ring.error();
    (i == 0 ? polygon.outer : polygon.holes.emplace_back()) = std::move(*ring);
  }
  outline.polygons.push_back(std::move(polygon));
  return Done{};
}

Result<Done> add_members(const json& members, Outline& outline);

// Adds the polygons of an object of GeoJSON.
Result<Done> add_object(const json& object, Outline& outline) {
  if (!object.is_object()) return Done{};
  const std::string type =
      object.contains("type") && object["type"].is_string() ? object["type"].get<std::string>() : "";
  if (type == "FeatureCollection" && object.contains("features")) return add_members(object["features"], outline);
  if (type == "GeometryCollection" && object.contains("geometries")) return add_members(object["geometries"], outline);
  if (type == "Feature" && object.contains("geometry")) return add_object(object["geometry"], outline);
  if (!object.contains("coordinates")) return Done{};
  if (type == "Polygon") return add_polygon_of_json(object["coordinates"], outline);
  if (type != "MultiPolygon") return Done{};
  for (const json& rings : object["coordinates"])
    if (const Result<Done> done = add_polygon_of_json(rings, outline); !done) return done;
  return Done{};
}

Result<Done> add_members(const json& members, Outline& outline) {
  for (const json& member : members)
    if (const Result<Done> done = add_object(member, outline); !done) return done;
  return Done{};
}

// Error: the coordinates are not longitudes and latitudes.
Result<Done> check_crs(const json& object, const std::string& name) {
  if (!object.is_object() || !object.contains("crs") || !object["crs"].is_object()) return Done{};
  const std::string crs = object["crs"].dump();
  if (crs.find("CRS84") != std::string::npos || crs.find("4326") != std::string::npos) return Done{};
  return Error{name, fmt::format("has coordinates of another system ({}); expected WGS84 (longitude, latitude)", crs)};
}

struct PolyLine {
  std::string_view text;  // without spaces at the ends
  std::size_t number = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

std::vector<PolyLine> poly_lines_of(std::string_view text) {
  std::vector<PolyLine> lines;
  std::size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    if (const std::string_view rest = trimmed(line); !rest.empty()) lines.push_back({rest, number});
  }
  return lines;
}

std::optional<LonLat> place_of(std::string_view line) {
  const auto gap = line.find_first_of(" \t");
  if (gap == std::string_view::npos) return std::nullopt;
  const std::string_view rest = trimmed(line.substr(gap));
  const auto lon = number_in<double>(line.substr(0, gap)),
             lat = number_in<double>(rest.substr(0, rest.find_first_of(" \t")));
  if (!lon || !lat) return std::nullopt;
  return LonLat{*lon, *lat};
}

bool is_around(const LonLatRing& ring, LonLat at) {
  bool is_inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LonLat a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.lat_deg > at.lat_deg) == (b.lat_deg > at.lat_deg)) continue;
    if (at.lon_deg < a.lon_deg + (at.lat_deg - a.lat_deg) / (b.lat_deg - a.lat_deg) * (b.lon_deg - a.lon_deg))
      is_inside = !is_inside;
  }
  return is_inside;
}

// Adds holes to the polygons around them, else to the last one, of which check_outline() then says that it misses them.
Result<Done> add_holes(std::vector<LonLatRing> holes, Outline& outline) {
  if (!holes.empty() && outline.polygons.empty()) return Error{outline.where, "has holes but no outer ring"};
  for (LonLatRing& hole : holes) {
    LonLatPolygon* around = &outline.polygons.back();
    for (LonLatPolygon& polygon : outline.polygons)
      if (!hole.empty() && is_around(polygon.outer, hole.front())) around = &polygon;
    around->holes.push_back(std::move(hole));
  }
  return Done{};
}

}  // namespace

Result<Outline> parse_geojson_outline(std::string_view text, const std::string& name) {
  json object;
  try {
    object = json::parse(without_byte_order_mark(text));
  } catch (const json::parse_error& error) {
    return Error{fmt::format("{}, byte {}", name, error.byte), "expected GeoJSON, found malformed JSON"};
  }
  Outline outline{name, {}};
  if (const Result<Done> done = check_crs(object, name); !done) return done.error();
  if (const Result<Done> done = add_object(object, outline); !done) return done.error();
  if (outline.polygons.empty()) return Error{name, "has no Polygon or MultiPolygon"};
  return outline;
}

Result<Outline> parse_poly_outline(std::string_view text, const std::string& name) {
  const std::vector<PolyLine> lines = poly_lines_of(without_byte_order_mark(text));
  const auto at_line = [&](std::size_t i, std::string message) {
    return Error{fmt::format("{}:{}", name,
                             i < lines.size() ? lines[i].number
                             : lines.empty()  ? 1
                                              : lines.back().number),
                 std::move(message)};
  };
  Outline outline{name, {}};
  std::vector<LonLatRing> holes;
  std::size_t i = 1;  // after the title
  for (; i < lines.size() && lines[i].text != "END"; ++i) {
    const bool is_hole = lines[i].text.starts_with('!');
    LonLatRing ring;
    for (++i; i < lines.size() && lines[i].text != "END"; ++i) {
      const std::optional<LonLat> at = place_of(lines[i].text);
      if (!at) return at_line(i, fmt::format("expected longitude and latitude, or END, found \"{}\"", lines[i].text));
      ring.push_back(*at);
    }
    if (i == lines.size()) return at_line(i, "expected END after the points of a ring, found the end of the file");
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (is_hole)
      holes.push_back(std::move(ring));
    else
      outline.polygons.push_back({std::move(ring), {}});
  }
  if (i >= lines.size())
    return at_line(i, "expected the polygon format of Osmosis (a title, rings, END) or a name that ends in .geojson");
  if (const Result<Done> done = add_holes(std::move(holes), outline); !done) return done.error();
  if (outline.polygons.empty()) return Error{name, "has no polygon"};
  return outline;
}

}  // namespace citykiln::source
