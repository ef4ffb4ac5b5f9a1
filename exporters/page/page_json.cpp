#include "exporters/page/page_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/contract/findings/assumption_names.h"
#include "compiler/contract/findings/code_names.h"

namespace citykiln::exporters {
namespace {

using OrderedJson = nlohmann::ordered_json;

double with_four_digits(double value) { return std::stod(fmt::format("{:.4g}", value)); }
double in_centimetres(double value) { return std::floor(value * 100 + 0.5) / 100; }

OrderedJson rgb_json(const PageRgb& rgb) {
  OrderedJson json = OrderedJson::array();
  for (const double c : rgb) json.push_back(with_four_digits(c));
  return json;
}

OrderedJson entry_json(const PageSky& sky) {
  return {{"time", sky.time},
          {"label", sky.label},
          {"is_of_run", sky.is_of_run},
          {"are_lamps_lit", sky.are_lamps_lit},
          {"file", sky.file}};
}

OrderedJson assumption_texts() {
  OrderedJson json = OrderedJson::object();
  for (std::size_t i = 0; i < static_cast<std::size_t>(Assumption::kCount); ++i) {
    const auto assumption = static_cast<Assumption>(i);
    json[std::string(name_of(assumption))] = text_of(assumption);
  }
  return json;
}

OrderedJson code_texts() {
  OrderedJson json = OrderedJson::object();
  for (const Code code : all_codes()) json[std::string(name_of(code))] = text_of(code);
  return json;
}

OrderedJson class_counts(const FeatureRecords& records) {
  std::map<std::string, int> counts;
  for (const auto& [id, record] : records)
    if (!record.kind.empty()) ++counts[record.kind];
  return counts;
}

struct ToJson {
  OrderedJson operator()(double value) const { return in_centimetres(value); }
  template <typename T>
  OrderedJson operator()(const T& value) const {
    return value;
  }
};

OrderedJson record_json(const FeatureRecord& record) {
  OrderedJson json = {{"class", record.kind}};
  if (!record.name.empty()) json["name"] = record.name;
  json["at"] = {in_centimetres(record.at.x), in_centimetres(record.at.y), in_centimetres(record.at.z)};
  json["size_m"] = std::ceil(record.size_m);
  if (record.height_m > 0) json["height_m"] = in_centimetres(record.height_m);
  if (record.assumed != kNoAssumptions) json["assumed"] = names_in(record.assumed);
  for (const map::TagView& tag : record.tags.views()) json["tags"][std::string(tag.key)] = tag.value;
  for (const auto& [name, value] : record.recipe) json["recipe"][name] = std::visit(ToJson{}, value);
  return json;
}

// Keys of names in other languages and scripts by which an element is looked for.
constexpr std::array<std::string_view, 6> kNameKeys = {"name:en",       "int_name",   "alt_name",
                                                       "official_name", "short_name", "loc_name"};

/// Returns the names of an element, each once: its name, and those of the tags that the run keeps.
std::vector<std::string> element_names(const FeatureRecord& record) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.emplace_back(name);
  };
  add(record.name);
  for (const map::TagView& tag : record.tags.views())
    if (std::ranges::find(kNameKeys, tag.key) != kNameKeys.end()) add(tag.value);
  return names;
}

// Bytes that are no UTF-8 become U+FFFD.
std::string text_of_json(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

std::string page_json(const PageFacts& facts, const FeatureRecords& records) {
  OrderedJson json = {
      {"title", facts.title},
      {"attributions", facts.attributions},
      {"levels_m", facts.levels_m},
      {"region_m", {facts.region_m.min.x, facts.region_m.min.y, facts.region_m.max.x, facts.region_m.max.y}},
      {"ground_m", in_centimetres(facts.ground_m)},
      {"visibility_km", in_centimetres(facts.visibility_km)},
      {"lights", facts.lights},
      {"has_tags", facts.has_tags},
      {"feature_files", facts.feature_files},
      {"assumptions", assumption_texts()},
      {"codes", code_texts()},
      {"classes", class_counts(records)}};
  json["skies"] = OrderedJson::array();
  for (const PageSky& sky : facts.skies) json["skies"].push_back(entry_json(sky));
  return text_of_json(json) + "\n";
}

std::string sky_json(const PageSkyTable& sky) {
  OrderedJson radiance = OrderedJson::array();
  for (const PageRgb& rgb : sky.radiance)
    for (const double c : rgb) radiance.push_back(with_four_digits(c));
  const OrderedJson json = {{"to_light", {sky.to_light.x, sky.to_light.y, sky.to_light.z}},
                            {"light", rgb_json(sky.light)},
                            {"disk", rgb_json(sky.disk)},
                            {"white_ground", rgb_json(sky.white_ground)},
                            {"ground", rgb_json(sky.ground)},
                            {"columns", sky.columns},
                            {"rows", sky.rows},
                            {"radiance", std::move(radiance)}};
  return text_of_json(json) + "\n";
}

std::size_t feature_file_count(const FeatureRecords& records) {
  constexpr std::size_t kRecords = 500;
  return (records.size() + kRecords - 1) / kRecords;
}

std::vector<std::string> feature_files(const FeatureRecords& records, std::size_t count) {
  std::vector<std::string> texts(count);
  for (const auto& [id, record] : records) {
    std::string& text = texts[static_cast<std::size_t>(std::abs(id.id)) % count];
    text += fmt::format("{}\"{}\":{}", text.empty() ? "{\n" : ",\n", to_string(id), text_of_json(record_json(record)));
  }
  for (std::string& text : texts) text += text.empty() ? "{}\n" : "\n}\n";
  return texts;
}

std::string names_json(const FeatureRecords& records) {
  std::vector<std::pair<std::string, OsmId>> names;
  for (const auto& [id, record] : records)
    for (const std::string& name : element_names(record)) names.emplace_back(name, id);
  std::ranges::sort(names);
  std::string text = "[";
  for (const auto& [name, id] : names) {
    const FeatureRecord& record = records.at(id);
    const OrderedJson row = {name, to_string(id), record.kind, std::lround(record.at.x), std::lround(record.at.y)};
    text += (text.size() > 1 ? ",\n" : "\n") + text_of_json(row);
  }
  return text + "\n]\n";
}

}  // namespace citykiln::exporters
