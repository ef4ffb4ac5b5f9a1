#include "compiler/ground/water/strong_components.h"

#include <algorithm>

namespace citykiln::ground {
namespace {

constexpr std::uint32_t kUnseen = 0xffffffffu;

struct Visit {
  std::uint32_t node;
  std::size_t next = 0;  // of its successors
};

class Search {
 public:
  explicit Search(const std::vector<std::vector<std::uint32_t>>& successors)
      : successors_(successors), number_(successors.size(), kUnseen), low_(successors.size(), kUnseen) {
    components_.of.assign(successors.size(), kUnseen);
  }

  Components run() {
    for (std::uint32_t i = 0; i < successors_.size(); ++i) {
      if (number_[i] != kUnseen) continue;
      enter(i);
      while (!path_.empty()) step();
    }
    return std::move(components_);
  }

 private:
  void enter(std::uint32_t node) {
    number_[node] = low_[node] = seen_++;
    open_.push_back(node);
    path_.push_back({node});
  }

  // all that was opened since is one component
  void close(std::uint32_t node) {
    for (std::uint32_t last = kUnseen; last != node;) {
      last = open_.back();
      open_.pop_back();
      components_.of[last] = components_.count;
    }
    ++components_.count;
  }

  void step() {
    Visit& visit = path_.back();
    const std::uint32_t node = visit.node;
    if (visit.next < successors_[node].size()) {
      const std::uint32_t s = successors_[node][visit.next++];
      if (number_[s] == kUnseen)
        enter(s);
      else if (components_.of[s] == kUnseen)
        low_[node] = std::min(low_[node], number_[s]);
      return;
    }
    if (low_[node] == number_[node]) close(node);
    path_.pop_back();
    if (!path_.empty()) low_[path_.back().node] = std::min(low_[path_.back().node], low_[node]);
  }

  const std::vector<std::vector<std::uint32_t>>& successors_;
  Components components_;
  std::vector<std::uint32_t> number_, low_, open_;
  std::vector<Visit> path_;
  std::uint32_t seen_ = 0;
};

}  // namespace

Components strong_components(const std::vector<std::vector<std::uint32_t>>& successors) {
  return Search(successors).run();
}

}  // namespace citykiln::ground
