#include "compiler/commands/serve/content_cache.h"

#include <algorithm>
#include <chrono>

namespace citykiln::commands {
namespace {

// How often a waiting request looks whether its client is still there.
constexpr std::chrono::milliseconds kLook{50};

}  // namespace

SharedBytes ContentCache::find(const std::string& name) {
  const auto found = kept_.find(name);
  if (found == kept_.end()) return nullptr;
  uses_.splice(uses_.begin(), uses_, found->second.use);
  return found->second.bytes;
}

void ContentCache::keep(const std::string& name, const SharedBytes& bytes) {
  if (bytes->size() > most_bytes_) return;
  uses_.push_front(name);
  kept_[name] = {bytes, uses_.begin()};
  counters_.bytes += bytes->size();
  while (counters_.bytes > most_bytes_) {
    counters_.bytes -= kept_.at(uses_.back()).bytes->size();
    kept_.erase(uses_.back());
    uses_.pop_back();
  }
}

// The first of the works that have not begun, if there is room for one more.
bool ContentCache::is_next(const Work& work) const {
  return begun_ < at_once_ && std::ranges::none_of(works_, [&](const auto& other) {
           return !other.second->is_begun && other.second->number < work.number;
         });
}

SharedBytes ContentCache::make_now(const std::string& name, const std::shared_ptr<Work>& work, const Make& make,
                                   std::unique_lock<std::mutex>& lock) {
  work->is_begun = true, ++begun_;
  lock.unlock();
  Result<std::vector<std::byte>> made = make();
  lock.lock();
  --begun_, work->is_done = true;
  if (!made) {
    ++counters_.failed, counters_.failure = to_string(made.error());
  } else {
    ++counters_.made;
    work->bytes = std::make_shared<const std::vector<std::byte>>(std::move(*made));
    keep(name, work->bytes);
  }
  works_.erase(name);
  changed_.notify_all();
  return work->bytes;
}

SharedBytes ContentCache::get(const std::string& name, const IsWanted& is_wanted, const Make& make) {
  std::unique_lock lock(mutex_);
  if (SharedBytes bytes = find(name)) {
    ++counters_.found;
    return bytes;
  }
  std::shared_ptr<Work>& own = works_[name];
  if (!own) own = std::make_shared<Work>(Work{.number = next_number_++});
  const std::shared_ptr<Work> work = own;
  ++waiting_[name];
  bool is_still_wanted = true;
  while (is_still_wanted && !work->is_done) {
    if (!work->is_begun && is_next(*work)) {
      make_now(name, work, make, lock);
      break;
    }
    changed_.wait_for(lock, kLook);
    is_still_wanted = is_wanted();
  }
  const bool is_last = --waiting_[name] == 0;
  if (is_last) waiting_.erase(name);
  if (work->is_done) return work->bytes;
  ++counters_.given_up;
  if (is_last && !work->is_begun) works_.erase(name), changed_.notify_all();
  return nullptr;
}

ContentCache::Counters ContentCache::counters() const {
  const std::lock_guard lock(mutex_);
  return counters_;
}

}  // namespace citykiln::commands
