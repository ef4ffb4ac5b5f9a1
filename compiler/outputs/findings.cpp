#include "compiler/outputs/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <tuple>

#include "compiler/contract/findings/code_names.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/degrees.h"
#include "compiler/scene/kinds.h"

namespace citykiln::outputs {
namespace {

/// Returns the tile that covers a place; empty outside the extent.
std::optional<scene::TileKey> tile_at(const scene::Header& header, Vec2 at) {
  const Box2& extent = header.extent;
  if (at.x < extent.min.x || at.x > extent.max.x || at.y < extent.min.y || at.y > extent.max.y) return std::nullopt;
  return scene::TileKey{static_cast<std::int32_t>(std::floor(at.x / header.tile_m)),
                        static_cast<std::int32_t>(std::floor(at.y / header.tile_m))};
}

// The place of an object: the middle vertex of a line, the first vertex of a footprint. Watercourses, landforms and
// areas have the place of their element.
Vec2 point_of(const buildings::Building& b) { return b.footprint.outer.front(); }
template <typename Object>
Vec2 point_of(const Object& object) {
  if constexpr (requires { object.at; })
    return object.at;
  else if constexpr (requires { object.axis; })
    return object.axis[object.axis.size() / 2];
  else
    return middle_of(object);
}

// The step that decides where several recipes have one id: the first one counts. 3: none has a place.
template <typename Object>
constexpr int kPlaceStep =
    std::derived_from<Object, roads::Road>                                                      ? 2
    : std::same_as<Object, props::Barrier> || std::same_as<Object, plants::TreeRow>             ? 1
    : std::derived_from<Object, roads::Strip> || std::same_as<Object, ground::LandCoverPolygon> ? 3
                                                                                                : 0;

// The places of objects in a chunk.
std::map<OsmId, Vec2> places_in(const scene::Chunk& chunk, const std::set<OsmId>& ids) {
  std::map<OsmId, Vec2> places;
  for (const int step : {0, 1, 2})
    scene::for_each_element_kind(chunk, [&]<typename Object>(std::string_view, const std::vector<Object>& objects) {
      if constexpr (kPlaceStep<Object> < 3)
        for (const Object& object : objects)
          if (kPlaceStep<Object> == step && ids.contains(object.id.osm))
            places.emplace(object.id.osm, point_of(object));
    });
  return places;
}

// How much is missing. An area that reaches out of the extract is larger than anything in it.
double loss_of(const Diagnosis& diagnosis) {
  if (severity_of(diagnosis.code) != Severity::kDropped) return 0;
  return diagnosis.code == Code::kIncompleteArea ? std::numeric_limits<double>::infinity() : rounded_size(diagnosis);
}

// Losses first, the largest of them first. Sizes count as they are written, so that a list that was read sorts alike.
auto sort_key(const Finding& finding) {
  const Diagnosis& d = finding.diagnosis;
  const Severity severity = severity_of(d.code);
  const double size = rounded_size(d);
  return std::tuple(-static_cast<int>(severity), -loss_of(d), d.code, d.object, d.other, finding.tile, finding.level,
                    size, std::string_view(finding.tags));
}

std::string text_of(const Finding& finding) {
  const Diagnosis& d = finding.diagnosis;
  nlohmann::ordered_json properties = {{"code", name_of(d.code)}, {"severity", name_of(severity_of(d.code))}};
  properties["id"] = nullptr;
  if (d.object.type != OsmType::kNone) properties["id"] = to_string(d.object);
  if (d.other.type != OsmType::kNone) properties["other"] = to_string(d.other);
  properties["size"] = rounded_size(d);
  if (!finding.tags.empty()) properties["tags"] = finding.tags;
  if (finding.tile) properties["tile"] = to_string(*finding.tile);
  if (finding.level) properties["level"] = *finding.level;
  const std::string geometry =
      finding.at ? fmt::format(R"({{"type":"Point","coordinates":[{},{}]}})", map::degrees_text(finding.at->lon_deg),
                               map::degrees_text(finding.at->lat_deg))
                 : "null";
  return fmt::format(R"({{"type":"Feature","properties":{},"geometry":{}}})", properties.dump(), geometry);
}

// Parses the id of an element, such as "w123"; OsmType::kNone for other texts.
OsmId id_of(const nlohmann::json& id) {
  constexpr std::string_view kTypes = "-nwrl";
  if (!id.is_string()) return {};
  const std::string text = id.get<std::string>();
  const std::size_t type = kTypes.find(text.empty() ? '-' : text.front());
  const auto number = number_in<std::int64_t>(std::string_view(text).substr(type == std::string_view::npos ? 0 : 1));
  if (type == std::string_view::npos || type == 0 || !number) return {};
  return {static_cast<OsmType>(type), *number};
}

// Returns the tile of a feature, such as "3_-2".
std::optional<scene::TileKey> tile_of(const nlohmann::json& properties) {
  if (!properties.contains("tile")) return std::nullopt;
  const auto numbers = numbers_in<std::int32_t>(properties.at("tile").get<std::string>(), '_', 2);
  return numbers ? std::optional(scene::TileKey{(*numbers)[0], (*numbers)[1]}) : std::nullopt;
}

// Reads one feature; empty if this program does not know its code.
std::optional<Finding> finding_of(const nlohmann::json& feature) {
  const nlohmann::json& properties = feature.at("properties");
  const std::optional<Code> code = code_named(properties.at("code").get<std::string>());
  if (!code) return std::nullopt;
  Finding finding;
  finding.diagnosis.code = *code;
  finding.diagnosis.object = id_of(properties.at("id"));
  finding.diagnosis.size = properties.at("size").get<double>();
  finding.tile = tile_of(properties);
  if (properties.contains("other")) finding.diagnosis.other = id_of(properties.at("other"));
  finding.tags = properties.value("tags", "");
  if (!properties.contains("other")) finding.diagnosis.tag = finding.tags;
  if (properties.contains("level")) finding.level = properties.at("level").get<std::size_t>();
  if (const nlohmann::json& geometry = feature.at("geometry"); !geometry.is_null())
    finding.at = {geometry.at("coordinates").at(0).get<double>(), geometry.at("coordinates").at(1).get<double>()};
  return finding;
}

// Returns the tag of a diagnosis about one, such as "width=wide"; for two objects their height tags, such as "w1:
// tunnel=yes layer=-1; w2: no tags of height"; else "".
std::string tags_of(const Diagnosis& diagnosis, const map::LayerTags& layer_tags) {
  if (diagnosis.other.type == OsmType::kNone) return diagnosis.tag;
  std::string text;
  for (const OsmId object : {diagnosis.object, diagnosis.other}) {
    const auto found = layer_tags.find(object);
    if (found == layer_tags.end()) continue;
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", to_string(object),
                        found->second.empty() ? "no tags of height" : found->second);
  }
  return text;
}

}  // namespace

double rounded_size(const Diagnosis& diagnosis) { return std::floor(diagnosis.size * 1000 + 0.5) / 1000; }

std::vector<Finding> findings_of(const Report& report, const map::Places& places, const map::LayerTags& layer_tags,
                                 const scene::Header& header) {
  const map::Plane plane(header.origin);
  std::vector<Finding> findings;
  for (const Diagnosis& diagnosis : report.diagnoses()) {
    Finding finding{diagnosis, std::nullopt, std::nullopt, {}, tags_of(diagnosis, layer_tags)};
    if (const auto found = places.find(diagnosis.object); found != places.end()) {
      finding.at = found->second;
      finding.tile = tile_at(header, plane.forward(found->second));
    }
    findings.push_back(finding);
  }
  return findings;
}

std::vector<Finding> findings_of(const Report& report, const scene::Header& header, const scene::Chunk& chunk,
                                 std::size_t level) {
  if (report.diagnoses().empty()) return {};
  std::set<OsmId> ids;
  for (const Diagnosis& diagnosis : report.diagnoses()) ids.insert(diagnosis.object);
  const std::map<OsmId, Vec2> places = places_in(chunk, ids);
  const Vec2 centre = scene::box_of(header, chunk.tile).centre();
  const map::Plane plane(header.origin);
  std::vector<Finding> findings;
  for (const Diagnosis& diagnosis : report.diagnoses()) {
    const auto found = places.find(diagnosis.object);
    const Vec2 at = diagnosis.at_m          ? Vec2{(*diagnosis.at_m)[0], (*diagnosis.at_m)[1]}
                    : found != places.end() ? found->second
                                            : centre;
    findings.push_back({diagnosis, plane.backward(at), chunk.tile, level, diagnosis.tag});
  }
  return findings;
}

std::string findings_json(std::vector<Finding> findings, const scene::Header& header) {
  std::ranges::stable_sort(findings, {}, sort_key);
  std::string text = R"({"type":"FeatureCollection","name":"findings","attribution":)" +
                     nlohmann::json(header.attributions).dump() + ",\"features\":[";
  for (std::size_t i = 0; i < findings.size(); ++i) text += (i > 0 ? ",\n" : "\n") + text_of(findings[i]);
  return text + "\n]}\n";
}

Result<std::vector<Finding>> parse_findings(std::string_view json) {
  std::vector<Finding> findings;
  try {
    const nlohmann::json collection = nlohmann::json::parse(json);
    for (const nlohmann::json& feature : collection.at("features"))
      if (std::optional<Finding> finding = finding_of(feature)) findings.push_back(std::move(*finding));
  } catch (const nlohmann::json::exception& wrong) {
    return Error{"", fmt::format("is not a list of findings: {}", wrong.what())};
  }
  return findings;
}

}  // namespace citykiln::outputs
