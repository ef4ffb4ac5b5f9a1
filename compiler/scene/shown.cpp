#include "compiler/scene/shown.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace citykiln::scene {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(SceneLayer::kCount)> kSceneLayerNames = {
    "ground", "roads", "water", "buildings", "structures", "things", "plants", "yards"};

}  // namespace

std::string_view name_of(SceneLayer layer) {
  assert(layer < SceneLayer::kCount);
  return kSceneLayerNames[static_cast<std::size_t>(layer)];
}

std::optional<SceneLayer> scene_layer_named(std::string_view name) {
  for (std::size_t i = 0; i < kSceneLayerNames.size(); ++i)
    if (kSceneLayerNames[i] == name) return static_cast<SceneLayer>(i);
  return std::nullopt;
}

Shown with_request(Shown shown, const ShownRequest& request) {
  shown.left_out = request.left_out.value_or(shown.left_out);
  shown.wood_density = request.wood_density.value_or(shown.wood_density);
  shown.lamps = request.lamps.value_or(shown.lamps);
  if (request.lit_windows) shown.lit_windows = *request.lit_windows;
  return shown;
}

}  // namespace citykiln::scene
