#include "preview/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "compiler/contract/system/for_each_slot.h"
#include "preview/adaptive_samples.h"
#include "preview/camera/camera_rays.h"
#include "preview/path_trace.h"
#include "preview/picture/running_mean.h"
#include "preview/scene/cell_cache.h"

namespace citykiln::preview {
namespace {

// Cells of a grid in Morton order, in which neighbours are near each other.

// A cell of a grid: column and row.
struct GridPlace {
  int x = 0, y = 0;
};

// Moves the lower 16 bits to the even positions.
std::uint32_t spread_16_bits(std::uint32_t v) {
  v = (v | (v << 8)) & 0x00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0fu;
  v = (v | (v << 2)) & 0x33333333u;
  return (v | (v << 1)) & 0x55555555u;
}

std::uint32_t code_of(const GridPlace& place) {
  return spread_16_bits(static_cast<std::uint32_t>(place.x)) |
         (spread_16_bits(static_cast<std::uint32_t>(place.y)) << 1);
}

// Returns all cells of a grid in Morton order (Z-order). Sizes up to 65536. O(n log n).
std::vector<GridPlace> in_morton_order(int width, int height) {
  std::vector<GridPlace> places;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) places.push_back({x, y});
  std::ranges::sort(places, {}, code_of);
  return places;
}

constexpr int kBlock_px = 32;

// Seed of the samples after pilot samples: independent of them.
constexpr std::uint64_t kFurtherSeed = 0x5851f42d4c957f2du;

// Tent filter, one pixel to each side: smooth edges without blur.
double tent(double u) { return u < 0.5 ? std::sqrt(2.0 * u) - 1 : 1 - std::sqrt(2.0 - 2.0 * u); }

// The inputs of a pixel.
struct Shot {
  TraceContext context;
  CameraRays rays;
  const Options& options;
};

// Samples of one sequence of points that are added to each pixel of a block.
struct SampleRange {
  std::uint64_t seed = 0;
  SampleGrid grid;
  int first = 0, count = 0;
};

// A block of pixels, the samples that its pixels have, and the sums of their weights and squared weights.
struct Block {
  GridPlace place;
  int samples = 0;
  double weights = 0, squared_weights = 0;
};

int blocks_along(int pixels) { return (pixels + kBlock_px - 1) / kBlock_px; }

PixelSums sample_pixel(const Shot& shot, const SampleRange& stretch, int x, int y) {
  const PixelSamples chances(stretch.seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), stretch.grid);
  PixelSums sums;
  for (int sample = stretch.first; sample < stretch.first + stretch.count; ++sample) {
    PathDraw draw(chances, static_cast<std::uint32_t>(sample));
    const UnitPair at = draw.next();
    const CameraRay ray = shot.rays.through(x + 0.5 + tent(at.u), y + 0.5 + tent(at.v), draw);
    add(sums, trace(shot.context, ray.from - shot.context.world.origin(), ray.direction, draw), shot.options.exposure);
  }
  return sums;
}

// Calls `visit(x, y, index)` for each pixel of a block, in Morton order.
template <typename Visit>
void for_each_pixel(const Block& block, const Options& options, Visit visit) {
  static const std::vector<GridPlace> kOrder = in_morton_order(kBlock_px, kBlock_px);
  for (const GridPlace& within : kOrder) {
    const int x = block.place.x * kBlock_px + within.x, y = block.place.y * kBlock_px + within.y;
    if (x < options.width && y < options.height)
      visit(x, y, static_cast<std::size_t>(y) * static_cast<std::size_t>(options.width) + static_cast<std::size_t>(x));
  }
}

// Adds samples of equal weight to all pixels of a block.
void sample_block(const Shot& shot, const SampleRange& stretch, double weight, Block& block, RunningMean& mean) {
  const double added = weight * stretch.count, share = added / (block.weights + added);
  for_each_pixel(block, shot.options, [&](int x, int y, std::size_t pixel) {
    mean.add(pixel, sample_pixel(shot, stretch, x, y), block.samples, block.samples == 0 ? 1 : share);
  });
  block.samples += stretch.count;
  block.weights += added;
  block.squared_weights += weight * added;
}

// Finished work in samples of blocks.
class Progress {
 public:
  Progress(const Options& options, double all) : options_(options), all_(all) {}

  void add(double done) {
    if (!options_.on_progress) return;
    const std::lock_guard one_at_a_time(mutex_);
    done_ += done;
    options_.on_progress(std::min(done_ / all_, 1.0));
  }
  void expect(double all) { all_ = all; }
  bool is_stopped() const { return options_.is_stopped != nullptr && *options_.is_stopped; }

 private:
  const Options& options_;
  double all_, done_ = 0;
  std::mutex mutex_;
};

// Whether cells had to be generated again: then blocks of pixels are finished one by one, since each pass over the
// picture needs all cells that it shows.
bool lacks_memory(const World& world) {
  const auto counters = world.counters();
  return counters && counters->regenerated > 0;
}

// Samples of one sequence for all blocks: of block i `counts[i]`, with `weights[i]` each, in passes that double. The
// sums of a pixel do not depend on how many passes its block takes at a time.
void run_passes(const Shot& shot, std::uint64_t seed, const std::vector<int>& counts,
                const std::vector<double>& weights, std::vector<Block>& blocks, RunningMean& mean, Progress& progress) {
  const Options& options = shot.options;
  const int most = *std::ranges::max_element(counts);
  const SampleGrid grid = grid_of(options.width, options.height, most);
  for (int first = 0, last = 1; first < most && !progress.is_stopped(); first = last, last = std::min(2 * last, most)) {
    if (lacks_memory(shot.context.world)) last = most;
    for_each_index(blocks.size(), options.threads, [&](std::size_t i) {
      for (int from = first; from < last; from = std::max(2 * from, 1)) {
        const int count = std::min({std::max(2 * from, 1), last, counts[i]}) - from;
        if (count <= 0 || progress.is_stopped()) return;
        sample_block(shot, {seed, grid, from, count}, weights[i], blocks[i], mean);
        progress.add(count);
      }
    });
    if (options.on_pass) options.on_pass(mean.image());
  }
}

PilotBlock pilot_of(const Block& block, const Options& options, const RunningMean& mean) {
  PilotBlock pilot;
  int pixels = 0;
  for_each_pixel(block, options, [&](int, int, std::size_t pixel) {
    const float* rgb = &mean.image().rgb[pixel * 3];
    pilot.luminance += luminance({rgb[0], rgb[1], rgb[2]});
    pilot.variance += mean.sample_variance(pixel, block.samples);
    ++pixels;
  });
  return {pilot.luminance / pixels, pilot.variance / pixels};
}

// The numbers of samples that blocks get after their pilot samples.
std::vector<int> counts_after_pilot(const SamplePlan& plan, const std::vector<Block>& blocks, const Options& options,
                                    const RunningMean& mean) {
  std::vector<PilotBlock> pilots;
  double sum = 0;
  for (const Block& block : blocks) sum += pilots.emplace_back(pilot_of(block, options, mean)).luminance;
  std::vector<int> counts;
  for (const PilotBlock& pilot : pilots)
    counts.push_back(further_samples(plan, pilot, sum / static_cast<double>(blocks.size()), options.noise));
  return counts;
}

void sample_picture(const Shot& shot, std::vector<Block>& blocks, RunningMean& mean) {
  const Options& options = shot.options;
  const SamplePlan plan = plan_samples(options.samples, options.noise);
  const double all = static_cast<double>(blocks.size());
  Progress progress(options, all * plan.most);
  const auto equal = [&](double weight) { return std::vector<double>(blocks.size(), weight); };
  const auto each = [&](int count) { return std::vector<int>(blocks.size(), count); };
  if (plan.pilot == 0) return run_passes(shot, options.seed, each(plan.most), equal(1), blocks, mean, progress);
  run_passes(shot, options.seed, each(plan.pilot), equal(1.0 / plan.most), blocks, mean, progress);
  if (progress.is_stopped()) return;
  const std::vector<int> counts = counts_after_pilot(plan, blocks, options, mean);
  std::vector<double> weights;
  double expected = all * plan.pilot;
  for (const int count : counts) weights.push_back((1 - plan.pilot_weight()) / count), expected += count;
  progress.expect(expected);
  run_passes(shot, options.seed ^ kFurtherSeed, counts, weights, blocks, mean, progress);
}

RenderStatistics statistics_of(const std::vector<Block>& blocks, const Options& options) {
  RenderStatistics statistics;
  statistics.least_samples = blocks.front().samples;
  for (const Block& block : blocks) {
    statistics.least_samples = std::min(statistics.least_samples, block.samples);
    statistics.most_samples = std::max(statistics.most_samples, block.samples);
    for_each_pixel(block, options,
                   [&](int, int, std::size_t) { statistics.paths += static_cast<std::uint64_t>(block.samples); });
  }
  return statistics;
}

}  // namespace

Image render(const World& world, const Lights& lights, const LocalLights& local, const Camera& camera,
             const Options& options) {
  if (options.width <= 0 || options.height <= 0) return {};
  const auto begin = std::chrono::steady_clock::now();
  const CameraRays rays(camera, options.width, options.height);
  const TraceContext context{.world = world,
                             .lights = lights,
                             .local = local,
                             .bounces = std::max(options.bounces, 0),
                             .pixel_rad = rays.pixel_rad(),
                             .roulette = options.roulette,
                             .has_caustics = options.has_caustics};
  const Shot shot{context, rays, options};
  std::vector<Block> blocks;
  for (const GridPlace& place : in_morton_order(blocks_along(options.width), blocks_along(options.height)))
    blocks.push_back({.place = place});
  RunningMean mean(options.width, options.height, options.has_guides);
  sample_picture(shot, blocks, mean);
  for (const Block& block : blocks)
    for_each_pixel(block, options, [&](int, int, std::size_t pixel) {
      const double all = block.weights * block.weights;
      mean.set_samples(pixel, block.samples, all > 0 ? block.squared_weights / all : 0);
    });
  Image image = std::move(mean).finish();
  image.statistics = statistics_of(blocks, options);
  image.statistics.is_complete = options.is_stopped == nullptr || !*options.is_stopped;
  image.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return image;
}

Image render(const World& world, const Lights& lights, const Camera& camera, const Options& options) {
  return render(world, lights, LocalLights(world, lights.lamps(), options.threads), camera, options);
}

Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera,
             const Options& options) {
  const World world(tiles, camera.eye);
  assert(!sky.inside);  // lights_of() of the command preview
  const auto lamps = sky::are_lamps_lit(sky) ? lamps_of(tiles) : std::vector<StreetLamp>();
  return render(world, Lights(sky::generate(sky), lamps), camera, options);
}

}  // namespace citykiln::preview
