#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/contract/texts/json_depth.h"
#include "compiler/contract/texts/nearest_name.h"
#include "compiler/invent/invent_settings.h"

namespace citykiln::invent {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostSpawners = 1000;

/// The line and column of a byte of the text, counted from 1.
std::string place_in_text(const std::string& where, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
  return fmt::format("{}:{}:{}", where, std::ranges::count(before, '\n') + 1, before.size() - line_begin + 1);
}

Error expected_value(std::string_view key, std::string_view what, const Json& found) {
  return {"", fmt::format("\"{}\": expected {}, found {}", key, what,
                          found.dump(-1, ' ', true, Json::error_handler_t::replace))};
}

Result<Done> unknown(std::string_view key, const std::vector<std::string>& known) {
  return Error{"", fmt::format("unknown setting \"{}\"{}", key, did_you_mean(key, known))};
}

Result<Done> put(const NamedSetting& setting, const Json& value) {
  const std::string key = fmt::format("{}.{}", setting.section, setting.name);
  if (bool* const* target = std::get_if<bool*>(&setting.value)) {
    if (!value.is_boolean()) return expected_value(key, "true or false", value);
    **target = value.get<bool>();
    return Done{};
  }
  if (std::string* const* target = std::get_if<std::string*>(&setting.value)) {
    if (!value.is_string()) return expected_value(key, "a text", value);
    **target = value.get<std::string>();
    return Done{};
  }
  const bool is_whole = std::holds_alternative<int*>(setting.value);
  const std::string what = fmt::format("a {}number from {} to {}", is_whole ? "whole " : "", setting.low, setting.high);
  if (!(is_whole ? value.is_number_integer() : value.is_number())) return expected_value(key, what, value);
  const double number = value.get<double>();
  if (!(number >= setting.low && number <= setting.high)) return expected_value(key, what, value);
  if (is_whole)
    *std::get<int*>(setting.value) = static_cast<int>(number);
  else
    *std::get<double*>(setting.value) = number;
  return Done{};
}

Result<Done> put_section(const std::string& section, const Json& values, const std::vector<NamedSetting>& all) {
  if (!values.is_object()) return expected_value(section, "an object of settings", values);
  for (const auto& [key, value] : values.items()) {
    const auto found = std::ranges::find_if(
        all, [&, &name = key](const NamedSetting& s) { return s.section == section && s.name == name; });
    if (found == all.end()) {
      std::vector<std::string> known;
      for (const NamedSetting& s : all)
        if (s.section == section) known.emplace_back(s.name);
      return unknown(key, known);
    }
    if (const Result<Done> done = put(*found, value); !done) return done;
  }
  return Done{};
}

Result<Done> put_spawners(const Json& values, std::vector<Spawner>& spawners) {
  if (!values.is_array() || values.size() > kMostSpawners)
    return expected_value("spawners", fmt::format("a list of up to {} objects", kMostSpawners), values);
  for (const Json& value : values) {
    spawners.emplace_back();
    if (const Result<Done> done = put_section("spawners", value, named_settings(spawners.back())); !done) return done;
  }
  return Done{};
}

Result<WorldKind> kind_in(const Json& document) {
  if (!document.contains("kind")) return WorldKind::kTown;
  const Json& value = document.at("kind");
  const auto kind = value.is_string() ? world_kind_named(value.get_ref<const std::string&>()) : std::nullopt;
  if (!kind) return expected_value("kind", "village, town, city, tiles or forest", value);
  return *kind;
}

Result<Done> put_place(const Json& value, LonLat& place) {
  const bool is_pair = value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
  const LonLat given = is_pair ? LonLat{value[0].get<double>(), value[1].get<double>()} : LonLat{};
  if (!is_pair || !(std::abs(given.lon_deg) <= 179 && std::abs(given.lat_deg) <= 80))
    return expected_value("place", "[longitude, latitude] in degrees, up to 179 and 80", value);
  place = given;
  return Done{};
}

Result<Done> put_key(const std::string& key, const Json& value, InventSettings& settings) {
  static const std::vector<std::string> kKnown = {"kind",    "seed",  "size", "place",   "terrain",
                                                  "country", "tiles", "spot", "spawners"};
  if (key == "kind") return Done{};
  if (key == "seed") {
    if (!value.is_number_unsigned()) return expected_value(key, "a whole number of at least 0", value);
    settings.seed = value.get<std::uint64_t>();
    return Done{};
  }
  if (key == "size") {
    if (!value.is_number() || !(value.get<double>() > 0 && value.get<double>() <= kMostSide_m))
      return expected_value(key, fmt::format("metres, up to {}", kMostSide_m), value);
    settings.side_m = whole_side_m(value.get<double>());
    return Done{};
  }
  if (key == "place") return put_place(value, settings.place);
  if (std::ranges::find(kKnown, key) == kKnown.end()) return unknown(key, kKnown);
  if (key == "spawners") return put_spawners(value, settings.spawners);
  return put_section(key, value, named_settings(settings));
}

Result<Json> document_of(const std::string& text, const std::string& where) {
  if (text.empty()) return Json::object();
  if (is_nested_too_deep(text)) return Error{where, "the JSON is nested too deep"};
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::parse_error& problem) {
    return Error{place_in_text(where, text, problem.byte), "invalid JSON at this place"};
  } catch (const Json::exception&) {
    return Error{where, "invalid JSON: a number is too large"};
  }
  if (!document.is_object())
    return Error{where, "expected a JSON object of settings, such as {\"kind\": \"forest\", \"seed\": 7}"};
  return document;
}

}  // namespace

Result<InventSettings> read_invent_settings(const std::string& text, const std::string& where,
                                            const AskedSettings& asked) {
  const Result<Json> document = document_of(text, where);
  if (!document) return document.error();
  const Result<WorldKind> kind = kind_in(*document);
  if (!kind) return Error{where, to_string(kind.error())};
  InventSettings settings = usual_settings(asked.kind.value_or(*kind));
  for (const auto& [key, value] : document->items())
    if (const Result<Done> done = put_key(key, value, settings); !done) return Error{where, to_string(done.error())};
  settings.seed = asked.seed.value_or(settings.seed);
  settings.side_m = asked.side_m ? whole_side_m(*asked.side_m) : settings.side_m;
  settings.place = asked.place.value_or(settings.place);
  return settings;
}

std::string text_of(const InventSettings& settings) {
  InventSettings copy = settings;
  Json document = {{"kind", name_of(settings.kind)},
                   {"seed", settings.seed},
                   {"size", settings.side_m},
                   {"place", {settings.place.lon_deg, settings.place.lat_deg}}};
  for (const NamedSetting& setting : named_settings(copy))
    std::visit([&](const auto* value) { document[std::string(setting.section)][std::string(setting.name)] = *value; },
               setting.value);
  document["spawners"] = Json::array();
  for (Spawner& spawner : copy.spawners) {
    Json object;
    for (const NamedSetting& setting : named_settings(spawner))
      std::visit([&](const auto* value) { object[std::string(setting.name)] = *value; }, setting.value);
    document["spawners"].push_back(object);
  }
  return document.dump(2) + "\n";
}

}  // namespace citykiln::invent
