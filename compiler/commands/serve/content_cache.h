// A cache of contents that are made on request. Requests for one content share the work, wait for their turn in the
// order in which they came, and are given up when no one waits for them.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <string>

#include "compiler/commands/serve_module/serve_io.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Thread-safe.
class ContentCache {
 public:
  /// @param most_bytes  The size of the cache. Contents that were asked for longest ago leave it. A content larger than
  ///                    that is sent and not kept.
  /// @param at_once     The number of contents that are made at the same time, > 0.
  ContentCache(std::uint64_t most_bytes, int at_once) : most_bytes_(most_bytes), at_once_(at_once) {}

  using Make = std::function<Result<std::vector<std::byte>>()>;
  /// Returns a content: from the cache, from another request that is making it, or from make(), which runs in the
  /// calling thread when it is its turn. Null if make() failed (counters() has its error), or if is_wanted() became
  /// false while the request waited. A make() that has begun is finished, and its content kept.
  ///
  /// @param is_wanted  Is called about every 50 ms under the lock of the cache, so it must be fast and must not use it.
  SharedBytes get(const std::string& name, const IsWanted& is_wanted, const Make& make);

  /// Counts until now: requests that were answered from the cache (found) or given up, and contents that were made or
  /// failed. A request that gets a content which another one has made is in none of them.
  struct Counters {
    std::uint64_t found = 0, made = 0, given_up = 0, failed = 0;
    std::uint64_t bytes = 0;  ///< In the cache now.
    std::string failure{};    ///< The latest error of a make().
  };
  Counters counters() const;

 private:
  /// A content that is made now, or waits for its turn.
  struct Work {
    std::uint64_t number = 0;  ///< In the order in which they came.
    bool is_begun = false, is_done = false;
    SharedBytes bytes{};
  };
  struct Kept {
    SharedBytes bytes;
    std::list<std::string>::iterator use;
  };

  SharedBytes find(const std::string& name);
  void keep(const std::string& name, const SharedBytes& bytes);
  bool is_next(const Work& work) const;
  SharedBytes make_now(const std::string& name, const std::shared_ptr<Work>& work, const Make& make,
                       std::unique_lock<std::mutex>& lock);

  std::uint64_t most_bytes_;
  int at_once_, begun_ = 0;
  std::uint64_t next_number_ = 0;
  std::map<std::string, Kept> kept_;
  std::list<std::string> uses_;  ///< Names in the cache, the latest use first.
  std::map<std::string, std::shared_ptr<Work>> works_;
  std::map<std::string, int> waiting_;  ///< Requests that wait for a content.
  Counters counters_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
};

}  // namespace citykiln::commands
