#include "preview/window/interactive.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>

#include "compiler/contract/system/load_module.h"
#include "preview/camera/camera.h"
#include "preview/camera/camera_rays.h"
#include "preview/picture/exposure.h"
#include "preview/picture/tone_map.h"
#include "preview/window_module/window_io.h"

namespace citykiln::preview {
namespace {

// A picture that is rendered by a separate thread. Refers to the world and its lights, which must outlive this object.
//
// While the camera moves, pictures are a quarter as wide and high, with 1 sample a pixel. Once it rests, the whole
// picture is rendered, and refined until all of its samples are taken.
class RefiningPicture {
 public:
  RefiningPicture(const World& world, const Lights& lights, const LocalLights& local, Options options);
  ~RefiningPicture();

  /// Starts again with another camera. A full picture that is being rendered is stopped; a small one is finished first
  /// if the camera still moves.
  void restart(const Camera& camera, bool is_moving);
  /// Returns the picture with the samples taken until now, if it is newer than the picture returned before; else empty.
  std::optional<Image> take_newer();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

// Pictures of a moving camera are this much smaller along each side.
constexpr int kSmaller = 4;

struct RefiningPicture::Work {
  const World& world;
  const Lights& lights;
  const LocalLights& local;
  Options options;

  std::mutex mutex{};
  std::condition_variable changed{};
  // by `mutex`
  std::optional<Camera> wanted{};  // not started yet
  bool is_moving = false, is_ended = false;
  std::optional<Image> newer{};

  std::atomic<bool> is_stopped = false;
  std::thread thread{};

  // The options of the wanted picture. Call under the mutex.
  Options options_now() {
    Options now = options;
    if (is_moving) {
      now.width = std::max(now.width / kSmaller, 1), now.height = std::max(now.height / kSmaller, 1);
      now.samples = 1, now.noise = 0;
    }
    now.is_stopped = &is_stopped;
    now.on_pass = [this](const Image& image) {
      const std::lock_guard one_at_a_time(mutex);
      if (!is_stopped) newer = image;
    };
    return now;
  }

  void run() {
    for (;;) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return wanted.has_value() || is_ended; });
      if (is_ended) return;
      const Camera camera = *wanted;
      wanted.reset();
      is_stopped = false;
      const Options now = options_now();
      lock.unlock();
      render(world, lights, local, camera, now);
    }
  }
};

RefiningPicture::RefiningPicture(const World& world, const Lights& lights, const LocalLights& local, Options options)
    : work_(new Work{.world = world, .lights = lights, .local = local, .options = std::move(options)}) {
  work_->thread = std::thread([work = work_.get()] { work->run(); });
}

RefiningPicture::~RefiningPicture() {
  {
    const std::lock_guard one_at_a_time(work_->mutex);
    work_->is_ended = true;
    work_->is_stopped = true;
  }
  work_->changed.notify_all();
  work_->thread.join();
}

void RefiningPicture::restart(const Camera& camera, bool is_moving) {
  const std::lock_guard one_at_a_time(work_->mutex);
  // a small picture is finished before the next one, so that some are shown while the camera moves
  if (!is_moving || !work_->is_moving) work_->is_stopped = true;
  work_->wanted = camera;
  work_->is_moving = is_moving;
  work_->changed.notify_all();
}

std::optional<Image> RefiningPicture::take_newer() {
  const std::lock_guard one_at_a_time(work_->mutex);
  std::optional<Image> taken = std::move(work_->newer);
  work_->newer.reset();
  return taken;
}

// ---- flight ---------------------------------------------------------------------------------------------------------

constexpr double kSpeed_m_s = 20, kFast = 10;

// Longest time of one step: after a pause the camera does not jump.
constexpr double kLongest_s = 0.2;

constexpr double kSteepest_rad = 89 * std::numbers::pi / 180;

// The view's direction, turned to the right and down by angles.
Vec3 turned_view(Vec3 forward, double right_rad, double down_rad) {
  const double bearing = std::atan2(forward.x, forward.y) + right_rad;
  const double rise = std::clamp(std::asin(std::clamp(forward.z, -1.0, 1.0)) - down_rad, -kSteepest_rad, kSteepest_rad);
  return {std::sin(bearing) * std::cos(rise), std::cos(bearing) * std::cos(rise), std::sin(rise)};
}

// True if input moves or turns the camera.
bool is_moving(const CitykilnInput& input) {
  return input.ahead != 0 || input.aside != 0 || input.upward != 0 || input.turn_px != 0 || input.tilt_px != 0;
}

// Returns the camera after input. Keys move it along the view, aside and up, at 20 m/s, or 200 m/s with shift. The
// mouse turns it about the vertical and tilts it to at most 89°; a drag over the picture's height turns by the field
// of view. The distance of look_at stays.
Camera moved(const Camera& camera, const CitykilnInput& input) {
  const ViewAxes axes = axes_of({camera.eye, camera.look_at});
  const double far_m = std::max(length(camera.look_at - camera.eye), 1.0);
  const double pixel_rad = camera.vertical_fov_deg * std::numbers::pi / 180 / std::max(input.height, 1);
  const double step_m = kSpeed_m_s * (input.is_fast != 0 ? kFast : 1) * std::clamp(input.seconds, 0.0, kLongest_s);
  const Vec3 way = axes.forward * input.ahead + axes.right * input.aside + Vec3{0, 0, input.upward};
  Camera next = camera;
  next.eye = camera.eye + unit(way) * step_m;
  const bool turns = input.turn_px != 0 || input.tilt_px != 0;
  const Vec3 forward =
      turns ? turned_view(axes.forward, input.turn_px * pixel_rad, input.tilt_px * pixel_rad) : axes.forward;
  next.look_at = next.eye + forward * far_m;
  return next;
}

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
