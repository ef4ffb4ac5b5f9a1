#include "compiler/spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/contract/texts/json_depth.h"
#include "compiler/contract/texts/nearest_name.h"
#include "compiler/settings.h"

namespace citykiln {
namespace {

using nlohmann::json;

/// The value as it would be written on the command line.
std::string text_of(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const json& item : value) text += (text.empty() ? "" : ",") + text_of(item);
  return text;
}

/// Returns "spec.json:3:14" for a byte offset of the text, counted from 1.
std::string place_of(const std::string& path, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
  return fmt::format("{}:{}:{}", path, std::count(before.begin(), before.end(), '\n') + 1,
                     before.size() - line_begin + 1);
}

/// A key of the outer object, and its place.
struct KeyPlace {
  std::string key;
  std::size_t byte = 0;  ///< Counted from 1.
};

/// Returns the keys of the outer object of a valid JSON text, in order: a key may be given twice.
std::vector<KeyPlace> keys_in(std::string_view text) {
  std::vector<KeyPlace> keys;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{' || text[i] == '[') ++depth;
    if (text[i] == '}' || text[i] == ']') --depth;
    if (text[i] != '"') continue;
    const std::size_t begin = i++;
    for (; i < text.size() && text[i] != '"'; ++i) i += text[i] == '\\';
    const std::size_t next = text.find_first_not_of(" \t\r\n", i + 1);
    if (depth == 1 && next != std::string_view::npos && text[next] == ':')
      keys.push_back({json::parse(text.substr(begin, i + 1 - begin)).get<std::string>(), begin + 1});
  }
  return keys;
}

Result<Done> apply_json(const Setting& setting, const json& value, CompileSpec& spec) {
  if (!setting.repeats || !value.is_array()) return apply(setting, text_of(value), spec);
  for (const json& item : value) {
    const Result<Done> done = apply(setting, text_of(item), spec);
    if (!done) return done;
  }
  return Done{};
}

Result<Done> apply_key(const std::string& key, const json& value, CompileSpec& spec) {
  for (const Setting& setting : settings()) {
    if (setting.name != key) continue;
    const Result<Done> done = apply_json(setting, value, spec);
    return done ? done : Error{"", fmt::format("\"{}\": {}", key, to_string(done.error()))};
  }
  std::vector<std::string> known;
  for (const Setting& setting : settings()) known.emplace_back(setting.name);
  return Error{
      "", fmt::format("unknown setting \"{}\"{} (citykiln compile --help lists all)", key, did_you_mean(key, known))};
}

Result<json> document_in(const std::string& path, const std::string& text) {
  if (is_nested_too_deep(text)) return Error{path, "the JSON is nested too deep"};
  json document;
  try {
    document = json::parse(text);
  } catch (const json::parse_error& problem) {
    return Error{place_of(path, text, problem.byte), "invalid JSON at this place"};
  } catch (const json::exception&) {
    return Error{path, "invalid JSON: a number is too large"};
  }
  if (!document.is_object())
    return Error{path, "expected a JSON object of settings, such as {\"map\": \"town.osm\", \"tile\": 512}"};
  return document;
}

}  // namespace

Result<CompileSpec> read_spec(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, "the file cannot be read"};
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Result<json> document = document_in(path, text);
  if (!document) return document.error();

  CompileSpec spec;
  std::set<std::string> given;
  for (const KeyPlace& at : keys_in(text)) {
    const std::string place = place_of(path, text, at.byte);
    if (!given.insert(at.key).second) return Error{place, fmt::format("\"{}\" is given twice", at.key)};
    const Result<Done> done = apply_key(at.key, document->at(at.key), spec);
    if (!done) return Error{place, to_string(done.error())};
  }
  return spec;
}

Result<Done> check_complete(const CompileSpec& spec) {
  if (spec.map_path.empty())
    return Error{"", "no map is given; expected a file such as town.osm.pbf, or the setting \"map\" in spec.json"};
  if (spec.outputs.folder.empty())
    return Error{"", "no output folder is given; add -o FOLDER, or the setting \"out\" to spec.json"};
  if (const Result<Done> fits = check_world(spec); !fits) return fits;
  return check_target(spec.outputs);
}

namespace {

// Checks the settings that have no meaning inside of a cylinder.
Result<Done> fits_cylinder(const CompileSpec& spec) {
  const Outputs& outputs = spec.outputs;
  if (outputs.page) return Error{"--emit", "page shows worlds on the ellipsoid; leave it out inside of a cylinder"};
  if (outputs.surroundings == AroundWish::kYes)
    return Error{"--surroundings", "there is no land around a map inside of a cylinder"};
  if (outputs.geoid) return Error{"--geoid-height", "is for the ellipsoid; leave it out inside of a cylinder"};
  if (spec.clouds && !spec.clouds->empty())
    return Error{"--clouds", "there are no clouds inside of a cylinder; leave it out"};
  return Done{};
}

}  // namespace

Result<Done> check_world(const CompileSpec& spec) {
  if (spec.world == World::kCylinder) return fits_cylinder(spec);
  if (spec.world == World::kPlane && has_tileset(spec.outputs))
    return Error{"--world", "3dtiles and 3tz are on the ellipsoid, found plane; leave --world out"};
  if (spec.world == World::kEllipsoid && !has_tileset(spec.outputs))
    return Error{"--world", "kiln and glb are in the plane, found ellipsoid; add --emit 3dtiles"};
  if (spec.outputs.page && !spec.outputs.tiles3d)
    return Error{"--emit", "page shows the tiles of 3dtiles; give both, such as 3dtiles,page"};
  const std::optional<map::GeoidSource>& geoid = spec.outputs.geoid;
  if (geoid && !geoid->level_m && !std::ifstream(geoid->name)) return Error{geoid->name, "the file cannot be read"};
  return Done{};
}

void clip_to(source::Outline outline, CompileSpec& spec) {
  if (!spec.map.bbox) spec.map.bbox = source::box_of(outline);
  spec.clip = std::move(outline);
}

cars::CarShare car_share_of(const CompileSpec& spec) {
  return spec.cars.value_or(has(spec.assume, Assumption::kParking) ? cars::kUsualCars : cars::kNoCars);
}

bool has_tileset(const Outputs& outputs) { return outputs.tiles3d || outputs.tiles3d_archive; }

Compression compression_of(const Outputs& outputs, Target target) {
  return outputs.compress.value_or(values_of(target).reads_quantised ? Compression::kLean : Compression::kNone);
}

Layout layout_of(const Outputs& outputs) {
  return outputs.layout.value_or(outputs.max_bytes ? Layout::kEmbedded : values_of(outputs.target).layout);
}

Result<Done> check_target(const Outputs& outputs) {
  // contents of 3D Tiles are written for CesiumJS, which reads all
  if (!outputs.glb || !outputs.compress) return Done{};
  bool (*const reads)(const TargetValues&) =
      outputs.compress == Compression::kLean || outputs.compress == Compression::kQuantize
          ? [](const TargetValues& t) { return t.reads_quantised; }
      : outputs.compress == Compression::kDraco   ? [](const TargetValues& t) { return t.reads_draco; }
      : outputs.compress == Compression::kMeshopt ? [](const TargetValues& t) { return t.reads_meshopt; }
                                                  : [](const TargetValues&) { return true; };
  const TargetValues& target = values_of(outputs.target);
  if (reads(target)) return Done{};
  return Error{"--compress", fmt::format("{} cannot be read by the target {}; add --target {}",
                                         name_of(*outputs.compress), target.name, targets_with(reads))};
}

}  // namespace citykiln
