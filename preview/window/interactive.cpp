#include "preview/window/interactive.h"

#include <cmath>

#include "compiler/contract/load_module.h"
#include "preview/picture/exposure.h"
#include "preview/picture/tone_map.h"
#include "preview/window/flight.h"
#include "preview/window/refining_picture.h"

namespace citykiln::preview {
namespace {

// The camera counts as resting after this time without input.
constexpr double kRest_s = 0.25;

// The functions of the window module, which is not there if GLFW was missing at build time.
struct Module {
  decltype(&citykiln_open_window) open = nullptr;
  decltype(&citykiln_show) show = nullptr;
  decltype(&citykiln_close_window) close = nullptr;
};

template <typename Function>
Result<Done> load(Function& function, const char* name) {
  const Result<void*> address = load_function("citykiln_window.so", name);
  if (!address) return Error{"--interactive", to_string(address.error())};
  function = reinterpret_cast<Function>(*address);
  return Done{};
}

Result<Module> load_module() {
  Module module;
  for (const Result<Done>& done : {load(module.open, "citykiln_open_window"), load(module.show, "citykiln_show"),
                                   load(module.close, "citykiln_close_window")})
    if (!done) return done.error();
  return module;
}

std::vector<std::uint8_t> exposed_bytes(const Image& image, double exposure) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.rgb.size());
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
    const float rgb[] = {static_cast<float>(image.rgb[i] * exposure), static_cast<float>(image.rgb[i + 1] * exposure),
                         static_cast<float>(image.rgb[i + 2] * exposure)};
    for (const std::uint8_t byte : tone_map(rgb)) bytes.push_back(byte);
  }
  return bytes;
}

// Opens a window; never null.
Result<void*> open_window(const Module& module, int width, int height, const char* title) {
  char error[512] = "";
  void* window = module.open(width, height, title, error, sizeof error);
  if (window == nullptr) return Error{"--interactive", std::string("no window could be opened: ") + error};
  return window;
}

}  // namespace

Result<Done> check_window() {
  const Result<Module> module = load_module();
  if (!module) return module.error();
  const Result<void*> window = open_window(*module, 64, 64, "citykiln starts");
  if (!window) return window.error();
  module->close(*window);
  return Done{};
}

Result<Done> show_interactive(const World& world, const Lights& lights, const LocalLights& local, const Camera& camera,
                              const Options& options, const WritePicture& write) {
  const Result<Module> module = load_module();
  if (!module) return module.error();
  const Result<void*> window = open_window(*module, options.width, options.height, "citykiln");
  if (!window) return window.error();
  Options unexposed = options;
  unexposed.exposure = 1;
  RefiningPicture picture(world, lights, local, unexposed);
  picture.restart(camera, false);
  Camera now = camera;
  Image shown;
  double exposure = options.exposure, rested_s = kRest_s;
  for (CitykilnInput input{}; input.is_closed == 0;) {
    const bool was_moving = rested_s < kRest_s;
    if (is_moving(input)) {
      now = moved(now, input), rested_s = 0;
      picture.restart(now, true);
    } else {
      rested_s += input.seconds;
      if (was_moving && rested_s >= kRest_s) picture.restart(now, false);
    }
    exposure *= std::exp2(input.exposure_stops);
    std::optional<Image> newer = picture.take_newer();
    const bool is_new = newer || input.exposure_stops != 0;
    if (newer) shown = std::move(*newer);
    if (input.asks_for_picture != 0 && !shown.rgb.empty()) {
      Image exposed = shown;
      expose(exposed, exposure);
      write(exposed, now, exposure);
    }
    const std::vector<std::uint8_t> bytes = is_new ? exposed_bytes(shown, exposure) : std::vector<std::uint8_t>();
    module->show(*window, bytes.empty() ? nullptr : bytes.data(), shown.width, shown.height, &input);
  }
  module->close(*window);
  return Done{};
}

}  // namespace citykiln::preview
