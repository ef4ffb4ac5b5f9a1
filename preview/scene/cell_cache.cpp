#include "preview/scene/cell_cache.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "compiler/contract/system/run_alone.h"
#include "preview/user_geometry.h"

namespace citykiln::preview {

void ReaderPhases::Reader::enter() {
  static std::atomic<std::size_t> threads = 0;
  thread_local const std::size_t shard = threads++ % kShards;
  counter_ = &phases_.shards_[shard].readers[phases_.phase_.load(std::memory_order_relaxed) & 1];
  counter_->fetch_add(1);
}

void ReaderPhases::Reader::leave() {
  if (counter_ != nullptr) counter_->fetch_sub(1, std::memory_order_release);
  counter_ = nullptr;
}

bool ReaderPhases::is_empty(std::size_t phase) const {
  return std::ranges::all_of(shards_, [&](const Shard& shard) { return shard.readers[phase].load() == 0; });
}

// Twice: a reader may have read the phase long before it counted itself.
void ReaderPhases::wait() {
  for (int turn = 0; turn < 2; ++turn) {
    const std::size_t before = phase_.fetch_add(1) & 1;
    while (!is_empty(before)) std::this_thread::yield();
  }
}

// Embree's callbacks for one cell.
struct CellCache::Calls {
  static void bounds(const RTCBoundsFunctionArguments* args) {
    *args->bounds_o = static_cast<const CellCache*>(args->geometryUserPtr)->box_of(args->primID);
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& cache = *static_cast<const CellCache*>(args->geometryUserPtr);
    CellRay& ray = *static_cast<CellRay*>(args->context);
    RTCRayHit& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    std::shared_ptr<const Cell> waited;
    const Cell* cell = cache.ready(args->primID);
    if (cell == nullptr && !cache.may_meet(args->primID, rayhit.ray)) return;
    if (cell == nullptr) cell = (waited = cache.wait_for(args->primID, ray)).get();
    RTCRayHit local = rayhit;
    local.hit.geomID = local.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(cell->geometry().scene(), args->context, &local);
    if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    rayhit.hit = local.hit, rayhit.ray.tfar = local.ray.tfar;
    ray.hit = cell;
    if (waited) ray.kept = std::move(waited);
  }

  static void occluded(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& cache = *static_cast<const CellCache*>(args->geometryUserPtr);
    CellRay& state = *static_cast<CellRay*>(args->context);
    RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
    std::shared_ptr<const Cell> waited;
    const Cell* cell = cache.ready(args->primID);
    if (cell == nullptr && !cache.may_meet(args->primID, ray)) return;
    if (cell == nullptr) cell = (waited = cache.wait_for(args->primID, state)).get();
    RTCRay local = ray;
    rtcOccluded1(cell->geometry().scene(), args->context, &local);
    if (local.tfar < 0) ray.tfar = -std::numeric_limits<float>::infinity();
  }
};

bool CellCache::on_memory(void* self, ssize_t bytes, bool) {
  static_cast<CellCache*>(self)->use_.hierarchies += bytes;
  return true;
}

CellCache::CellCache(RTCDevice device, std::shared_ptr<const CellSource> source, Vec3 origin, std::size_t budget_bytes)
    : device_(device),
      source_(std::move(source)),
      origin_(origin),
      budget_bytes_(static_cast<std::int64_t>(budget_bytes)),
      shared_(device, *source_, use_),
      slots_(source_->size()),
      top_(rtcNewScene(device)) {
  rtcSetDeviceMemoryMonitorFunction(device, on_memory, this);
  counters_.cells = source_->size();
  attach_user_geometry<Calls>(device, top_, source_->size(), this);
  rtcSetSceneFlags(top_, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(top_);
}

CellCache::~CellCache() {
  rtcReleaseScene(top_);
  slots_.clear();
  rtcSetDeviceMemoryMonitorFunction(device_, nullptr, nullptr);
}

// Single precision may round a bound inwards, and positions of cells too.
RTCBounds CellCache::box_of(std::size_t cell) const {
  const bake::Bounds& bounds = source_->bounds(cell);
  constexpr double kWider = 0x1p-20;
  const auto below = [](double v) { return static_cast<float>(v - kWider * (std::abs(v) + 1)); };
  const auto above = [](double v) { return static_cast<float>(v + kWider * (std::abs(v) + 1)); };
  RTCBounds box{};
  box.lower_x = below(bounds.plan.min.x - origin_.x), box.upper_x = above(bounds.plan.max.x - origin_.x);
  box.lower_y = below(bounds.plan.min.y - origin_.y), box.upper_y = above(bounds.plan.max.y - origin_.y);
  box.lower_z = below(bounds.low_m - origin_.z), box.upper_z = above(bounds.high_m - origin_.z);
  return box;
}

// The cell, or null; the reader of the caller's ray keeps it.
const Cell* CellCache::ready(std::size_t cell) const {
  Slot& slot = slots_[cell];
  const Cell* made = slot.ready.load();
  if (made == nullptr) return nullptr;
  // a store each time would move the line from processor to processor
  const std::uint32_t now = clock_.load(std::memory_order_relaxed);
  if (slot.used.load(std::memory_order_relaxed) != now) slot.used.store(now, std::memory_order_relaxed);
  return made;
}

bool CellCache::may_meet(std::size_t cell, const RTCRay& ray) const {
  const CellExtent* extent = slots_[cell].extent.load(std::memory_order_acquire);
  return extent == nullptr || extent->may_meet(ray);
}

// The ray is no reader meanwhile, so that evictions need not wait for it; the cell that it has hit is kept.
std::shared_ptr<const Cell> CellCache::wait_for(std::size_t cell, CellRay& ray) const {
  if (ray.hit != nullptr && ray.kept.get() != ray.hit) ray.kept = ray.hit->shared_from_this();
  ray.reader.leave();
  std::shared_ptr<const Cell> made = make(cell);
  ray.reader.enter();
  return made;
}

std::shared_ptr<const Cell> CellCache::make(std::size_t cell) const {
  Slot& slot = slots_[cell];
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !slot.is_generating; });
  if (slot.owner) return slot.owner;
  slot.is_generating = true;
  lock.unlock();
  std::shared_ptr<const Cell> made = generate(cell);
  lock.lock();
  ++counters_.generated;
  if (slot.was_generated) ++counters_.regenerated;
  slot.owner = made, slot.is_generating = false, slot.was_generated = true;
  slot.used = ++clock_;
  slot.ready.store(made.get());
  evict(cell);
  changed_.notify_all();
  return made;
}

std::shared_ptr<const Cell> CellCache::generate(std::size_t cell) const {
  const auto begin = std::chrono::steady_clock::now();
  std::shared_ptr<const Cell> made;
  run_alone([&] { made = std::make_shared<Cell>(device_, source_->bake(cell), origin_, shared_, use_); });
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  const std::lock_guard lock(mutex_);
  counters_.generating_s += spent.count();
  check_bounds(cell, *made);
  return made;
}

void CellCache::check_bounds(std::size_t cell, const Cell& made) const {
  const RTCBounds &in = made.bounds(), out = box_of(cell);
  if (in.lower_x > in.upper_x) return;  // nothing in it
  const double outside_m = std::max({out.lower_x - in.lower_x, in.upper_x - out.upper_x, out.lower_y - in.lower_y,
                                     in.upper_y - out.upper_y, out.lower_z - in.lower_z, in.upper_z - out.upper_z});
  counters_.outside_m = std::max(counters_.outside_m, outside_m);
}

std::int64_t CellCache::bytes() const { return use_.geometry + use_.hierarchies + use_.textures; }

// Keeps where a cell has anything, and hides the cell from rays that come now.
void CellCache::hide(Slot& slot) const {
  if (!slot.extent_owner) {
    auto extent = std::make_unique<CellExtent>(slot.owner->bounds());
    slot.owner->geometry().add_to(*extent);
    slot.extent.store(extent.get(), std::memory_order_release), slot.extent_owner = std::move(extent);
  }
  slot.ready.store(nullptr);
}

// Frees cells, those that were used least recently first, until the budget holds. Called under mutex_.
void CellCache::evict(std::size_t kept) const {
  while (bytes() > budget_bytes_) {
    std::vector<Slot*> oldest;
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (slots_[i].owner && i != kept) oldest.push_back(&slots_[i]);
    if (oldest.empty()) break;
    std::ranges::sort(oldest, {}, [](const Slot* slot) { return slot->used.load(); });
    std::vector<std::shared_ptr<const Cell>> freed;
    const std::int64_t over_bytes = bytes() - budget_bytes_;
    std::int64_t expected = 0;
    for (Slot* slot : oldest) {
      if (expected >= over_bytes) break;
      expected += static_cast<std::int64_t>(slot->owner->bytes());
      hide(*slot);
      freed.push_back(std::move(slot->owner));
      ++counters_.evicted;
    }
    readers_.wait();
  }
  const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, budget_bytes_ - bytes()));
  while (source_->tile_bytes() > kTileBytes + left && source_->drop_tile()) {
  }
  counters_.peak_bytes = std::max(counters_.peak_bytes, bytes());
  counters_.over_bytes = std::max(counters_.over_bytes, bytes() - budget_bytes_);
}

CellCounters CellCache::counters() const {
  const std::lock_guard lock(mutex_);
  CellCounters now = counters_;
  now.geometry_bytes = use_.geometry, now.hierarchy_bytes = use_.hierarchies, now.texture_bytes = use_.textures;
  now.prototype_bytes = static_cast<std::int64_t>(source_->prototypes().bytes());
  now.preparing_s = source_->preparing_s();
  now.tile_bytes = static_cast<std::int64_t>(source_->tile_bytes()), now.tiles_prepared = source_->tiles_prepared();
  return now;
}

}  // namespace citykiln::preview
