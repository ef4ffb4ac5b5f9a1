// Where a run is, and what each of its stages takes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace citykiln {

/// What a stage took. Never part of a promised byte.
struct StageCost {
  std::string stage;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;  ///< Largest resident memory while the stage ran.
};

/// Called when a stage begins, and as it goes on, with the done share of it, 0 to 1.
using OnProgress = std::function<void(std::string_view stage, double share)>;

/// Walks from stage to stage, tells the listener and measures each.
class StageTimer {
 public:
  explicit StageTimer(OnProgress on_progress) : on_progress_(std::move(on_progress)) {}

  /// Ends the stage before and begins this one.
  void enter(std::string_view stage);
  /// Ends the last stage and hands out the costs of all.
  std::vector<StageCost> finish();

 private:
  void close();

  OnProgress on_progress_;
  std::vector<StageCost> costs_;
  std::string stage_;  ///< Empty: none is open.
  double begin_s_ = 0;
};

}  // namespace citykiln
