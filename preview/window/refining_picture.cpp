#include "preview/window/refining_picture.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace citykiln::preview {

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

}  // namespace citykiln::preview
