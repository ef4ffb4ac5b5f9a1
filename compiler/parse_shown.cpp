#include "compiler/parse_shown.h"

#include <fmt/format.h>

#include <string>

#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/snap.h"
#include "compiler/parse_values.h"

namespace citykiln {
namespace {

std::string layer_names() {
  std::string names;
  for (std::uint8_t i = 0; i < static_cast<std::uint8_t>(scene::SceneLayer::kCount); ++i)
    names += fmt::format("{}{}", i == 0 ? "" : ", ", name_of(static_cast<scene::SceneLayer>(i)));
  return names;
}

}  // namespace

Result<scene::SceneLayers> parse_layers(std::string_view text) {
  scene::SceneLayers kept = scene::kNoLayers, removed = scene::kNoLayers;
  bool is_list = false;
  for (const std::string_view part : split(text, ',')) {
    const bool is_removed = part.starts_with('-');
    const std::string_view name = is_removed ? part.substr(1) : part;
    const std::optional<scene::SceneLayer> layer = scene::scene_layer_named(name);
    if (!layer && name != "all")
      return expected(fmt::format("layers to keep, such as ground,roads, or to leave out, such as -plants, among {}",
                                  layer_names()),
                      part);
    const scene::SceneLayers bits = layer ? bit_of(*layer) : scene::kAllLayers;
    is_list = is_list || !is_removed;
    (is_removed ? removed : kept) |= bits;
  }
  if (!is_list) kept = scene::kAllLayers;
  const auto shown = static_cast<scene::SceneLayers>(kept & ~removed);
  if (shown == scene::kNoLayers) return expected("at least one layer that is kept", text);
  return static_cast<scene::SceneLayers>(scene::kAllLayers & ~shown);
}

Result<double> parse_wood_density(std::string_view text) {
  const auto factor = number_in<double>(text);
  if (!factor || !(*factor >= 0 && *factor <= scene::kDensestWoods))
    return expected("a factor from 0 to 4, such as 0.5", text);
  return snapped_to(scene::kWoodDensityStep, *factor);
}

Result<scene::LampLight> parse_lamps(std::string_view text) {
  if (text == "auto") return scene::LampLight::kBySun;
  if (text == "on" || text == "true") return scene::LampLight::kOn;
  if (text == "off" || text == "false") return scene::LampLight::kOff;
  return expected("auto, on or off", text);
}

Result<std::optional<double>> parse_lit_windows(std::string_view text) {
  if (text == "usual") return std::optional<double>{};
  if (text == "none") return std::optional<double>{0};
  const auto share = number_in<double>(text);
  if (!share || !(*share >= 0 && *share <= 1))
    return expected("usual, none, or a share from 0 to 1, such as 0.7", text);
  return std::optional<double>{snapped_to(scene::kLitWindowsStep, *share)};
}

}  // namespace citykiln
