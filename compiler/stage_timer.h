// Measures the time and memory of the stages of a run, and reports progress.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace citykiln {

/// The time and memory of one stage. Not deterministic.
struct StageCost {
  std::string stage;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;  ///< Largest resident memory during the stage.
};

/// A function that is called at the start of a stage and during it, with the completed share of the stage, 0 to 1.
using OnProgress = std::function<void(std::string_view stage, double share)>;

/// Measures consecutive stages and calls a function at the start of each.
class StageTimer {
 public:
  explicit StageTimer(OnProgress on_progress) : on_progress_(std::move(on_progress)) {}

  /// Ends the previous stage and begins this one.
  void enter(std::string_view stage);
  /// Ends the last stage and returns the costs of all.
  std::vector<StageCost> finish();

 private:
  void close();

  OnProgress on_progress_;
  std::vector<StageCost> costs_;
  std::string stage_;  ///< Empty: no stage is open.
  double begin_s_ = 0;
};

}  // namespace citykiln
