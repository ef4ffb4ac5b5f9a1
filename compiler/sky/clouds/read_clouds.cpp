#include "compiler/sky/clouds/read_clouds.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

namespace citykiln::sky {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kLargestFile = 64 * 1024;

// Bases by the height where air from the ground condenses: about 125 m for each degree between temperature and dew
// point (Espy), 10 degrees on a fair day.
constexpr CloudLayer kFair = {CloudKind::kCumulus, 0.25, 1250, 2050, {5, 2}, 0};
constexpr CloudLayer kBroken = {CloudKind::kCumulus, 0.6, 1100, 2300, {8, 3}, 0};
constexpr CloudLayer kHigh = {CloudKind::kCirrus, 0.3, 8000, 8600, {20, 5}, 1};
constexpr CloudLayer kOvercast = {CloudKind::kStratus, 1, 700, 1150, {6, 0}, 0};

CloudRequest above_ground(const CloudLayer& layer) { return {layer, true, true}; }

std::optional<std::vector<CloudRequest>> named(const std::string& name) {
  if (name == "clear") return std::vector<CloudRequest>{};
  if (name == "fair") return fair_clouds();
  if (name == "broken") return std::vector{above_ground(kBroken), above_ground(kHigh)};
  if (name == "overcast") return std::vector{above_ground(kOvercast)};
  return std::nullopt;
}

std::optional<CloudKind> kind_named(const json& value) {
  for (int k = 0; k < static_cast<int>(CloudKind::kCount); ++k)
    if (value.is_string() && value == std::string(name_of(static_cast<CloudKind>(k)))) return static_cast<CloudKind>(k);
  return std::nullopt;
}

// Sets one key of a layer; an error text if that cannot be.
std::string set_key(CloudLayer& layer, const std::string& key, const json& value) {
  const auto is_pair = [&] {
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
  };
  if (key == "kind") {
    const auto kind = kind_named(value);
    if (!kind) return "\"kind\" is not \"cumulus\", \"stratus\" or \"cirrus\"";
    layer.kind = *kind;
  } else if (key == "wind") {
    if (!is_pair()) return "\"wind\" is not two numbers, such as [5, 2]";
    layer.wind = {value[0], value[1]};
  } else if (key == "seed") {
    if (!value.is_number_unsigned()) return "\"seed\" is not a whole number of at least 0";
    layer.seed = value;
  } else if (key == "cover" || key == "base" || key == "top") {
    if (!value.is_number()) return fmt::format("\"{}\" is not a number", key);
    (key == "cover" ? layer.cover : key == "base" ? layer.base_m : layer.top_m) = value;
  } else {
    return fmt::format("unknown key \"{}\"; the keys are kind, cover, base, top, wind and seed", key);
  }
  return "";
}

Result<CloudRequest> layer_of(const json& value, const std::string& path, std::size_t index) {
  const auto error = [&](const std::string& what) { return Error{path, fmt::format("layer {}: {}", index + 1, what)}; };
  if (!value.is_object() || !value.contains("kind")) return error("expected an object with a \"kind\"");
  CloudLayer layer;
  for (const auto& [key, item] : value.items())
    if (const std::string wrong = set_key(layer, key, item); !wrong.empty()) return error(wrong);
  if (!is_sound(layer))
    return error(
        fmt::format("expected a cover from 0 to 1, a base and a top {} m or more above it from {} to {} m, "
                    "and a wind of at most {} m/s",
                    kThinnestCloud_m, kLowestCloud_m, kHighestCloud_m, kStrongestWind_m_s));
  return CloudRequest{layer, false, !value.contains("seed")};
}

Result<std::vector<CloudRequest>> read_file(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
    return Error{path, "expected clear, fair, broken, overcast, or a file of cloud layers, which cannot be read"};
  if (size > kLargestFile) return Error{path, "is larger than 64 kB; expected a few layers of clouds"};
  std::ifstream file(path);
  const json text = json::parse(file, nullptr, false);
  if (!text.is_object() || !text.contains("layers") || !text["layers"].is_array() || text.size() != 1)
    return Error{path,
                 "expected {\"layers\": [{\"kind\": \"cumulus\", \"cover\": 0.4, \"base\": 1500, \"top\": 2400}]}"};
  if (text["layers"].size() > kMostCloudLayers)
    return Error{path, fmt::format("has {} layers; expected at most {}", text["layers"].size(), kMostCloudLayers)};
  std::vector<CloudRequest> layers;
  for (const json& value : text["layers"]) {
    Result<CloudRequest> layer = layer_of(value, path, layers.size());
    if (!layer) return layer.error();
    layers.push_back(*layer);
  }
  return layers;
}

}  // namespace

std::vector<CloudRequest> fair_clouds() { return {above_ground(kFair)}; }

Result<std::vector<CloudRequest>> read_clouds(const std::string& name_or_path) {
  if (auto layers = named(name_or_path)) return std::move(*layers);
  return read_file(name_or_path);
}

std::vector<CloudLayer> requested_clouds(std::span<const CloudRequest> requests, double ground_m, std::uint64_t seed) {
  const double lift_m = std::round(ground_m);  // whole metres
  std::vector<CloudLayer> layers;
  for (const CloudRequest& request : requests) {
    CloudLayer& layer = layers.emplace_back(request.layer);
    if (request.is_above_ground) layer.base_m += lift_m, layer.top_m += lift_m;
    if (request.adds_seed) layer.seed += seed;
  }
  return layers;
}

}  // namespace citykiln::sky
