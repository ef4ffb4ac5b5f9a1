// A cache of cells. A cell has the meshes of all objects on one piece of the ground; it is generated when a ray first
// enters its bounds, and freed when all cells exceed a budget.
//
//     ray ──► Embree's tree of the cells' bounds ──► a cell that is ready: its own hierarchy (no lock)
//                                               └──► a cell that is not: this thread generates it, others wait for it
//
// A thread that generates takes no part in other work (run_alone), so no thread waits for itself. A cell is a function
// of scene and view, so pictures do not depend on budget, threads or the order of rays.
#pragma once

#include <array>
#include <condition_variable>

#include "preview/scene/cell.h"

namespace citykiln::preview {

/// Counters of a cache, since its construction.
struct CellCounters {
  std::size_t cells = 0;           ///< Cells of the scene.
  std::size_t generated = 0;       ///< The number of generations; a cell that is generated twice counts twice.
  std::size_t regenerated = 0;     ///< Generations of a cell that had been generated before.
  std::size_t evicted = 0;         ///< The number of cells that were freed.
  std::size_t tiles_prepared = 0;  ///< The number of times that a tile was prepared for its cells.
  std::int64_t geometry_bytes = 0, hierarchy_bytes = 0, texture_bytes = 0, tile_bytes = 0,
               prototype_bytes = 0;  ///< Bytes in use now.
  std::int64_t peak_bytes = 0;       ///< The largest sum of geometry, hierarchies and textures after an eviction.
  std::int64_t over_bytes = 0;       ///< The largest excess over the budget.
  double outside_m = 0;              ///< Largest distance by which a cell was larger than its bounds. Must be 0.
  double generating_s = 0, preparing_s = 0;  ///< Sums over threads; generating includes preparing tiles.
};

/// A count of the threads (readers) that may use cells which are being evicted (freed). Two phases alternate, so that a
/// writer waits only for readers that began before it (McKenney, "Sleepable Read-Copy Update", 2006). Entering and
/// leaving cost one atomic addition each.
class ReaderPhases {
 public:
  class Reader {
   public:
    explicit Reader(ReaderPhases& phases) : phases_(phases) { enter(); }
    ~Reader() { leave(); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    void enter();
    void leave();

   private:
    ReaderPhases& phases_;
    std::atomic<std::int64_t>* counter_ = nullptr;
  };

  /// Waits until all readers that had entered have left. Only one thread at a time may call this function, and not a
  /// reader.
  void wait();

 private:
  static constexpr std::size_t kShards = 64;
  struct alignas(64) Shard {
    std::array<std::atomic<std::int64_t>, 2> readers{};
  };
  bool is_empty(std::size_t phase) const;

  std::array<Shard, kShards> shards_{};
  std::atomic<std::size_t> phase_ = 0;
};

/// The state of a ray on its way through cells. Embree passes this object to the callbacks as the ray's context.
struct CellRay : RTCIntersectContext {
  explicit CellRay(ReaderPhases& phases) : RTCIntersectContext{}, reader(phases) { rtcInitIntersectContext(this); }
  const Cell* hit = nullptr;         ///< The cell of the nearest hit; valid while this object lives.
  std::shared_ptr<const Cell> kept;  ///< Keeps `hit` alive if the ray has waited for a cell.
  ReaderPhases::Reader reader;
};

/// The cells of a source in one Embree scene. Thread-safe.
///
/// Memory: the budget holds for meshes, hierarchies and textures of cells, and for the prototypes and materials that
/// they show. Prepared tiles may use the rest of the budget. Not in the budget are the recipes, prepared tiles up to
/// kTileBytes (or one), the extents of freed cells (8 kB each), meshes of plants in the prototype cache, images of
/// materials, and memory that generating a cell needs for a moment.
class CellCache {
 public:
  static constexpr std::size_t kTileBytes = 100'000'000;

  /// @param origin        The world's origin in plane metres.
  /// @param budget_bytes   The limit above which cells are freed. The cell that a ray needs is kept even if it alone
  /// exceeds the budget.
  CellCache(RTCDevice device, std::shared_ptr<const CellSource> source, Vec3 origin, std::size_t budget_bytes);
  ~CellCache();

  RTCScene scene() const { return top_; }
  ReaderPhases& readers() const { return readers_; }
  CellCounters counters() const;

 private:
  struct Calls;
  struct Slot {
    std::atomic<const Cell*> ready = nullptr;
    std::atomic<const CellExtent*> extent = nullptr;  // since the cell was first freed
    std::atomic<std::uint32_t> used = 0;              // clock of the last use
    std::shared_ptr<const Cell> owner;                // the rest under mutex_
    std::unique_ptr<const CellExtent> extent_owner;
    bool is_generating = false, was_generated = false;
  };

  static bool on_memory(void* self, ssize_t bytes, bool post);
  RTCBounds box_of(std::size_t cell) const;
  const Cell* ready(std::size_t cell) const;
  bool may_meet(std::size_t cell, const RTCRay& ray) const;
  std::shared_ptr<const Cell> wait_for(std::size_t cell, CellRay& ray) const;
  std::shared_ptr<const Cell> make(std::size_t cell) const;
  std::shared_ptr<const Cell> generate(std::size_t cell) const;
  void check_bounds(std::size_t cell, const Cell& made) const;
  void hide(Slot& slot) const;
  void evict(std::size_t kept) const;
  std::int64_t bytes() const;

  RTCDevice device_;
  std::shared_ptr<const CellSource> source_;
  Vec3 origin_;
  std::int64_t budget_bytes_;
  mutable MemoryUse use_;
  mutable SharedByCells shared_;
  mutable ReaderPhases readers_;
  mutable std::vector<Slot> slots_;
  mutable std::atomic<std::uint32_t> clock_ = 1;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  mutable CellCounters counters_;
  RTCScene top_;
};

}  // namespace citykiln::preview
