#include "compiler/stage_timer.h"

#include <cassert>
#include <chrono>
#include <fstream>
#include <utility>

namespace citykiln {
namespace {

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// The kernel's high-water mark of resident memory; 0 on systems without /proc.
std::uint64_t peak_resident_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    std::uint64_t kilobytes = 0;
    status >> kilobytes;
    return kilobytes * 1024;
  }
  return 0;
}

/// Resets the high-water mark to the present resident memory (proc(5), clear_refs, 5), so that each stage has its own.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace

void StageTimer::enter(std::string_view stage) {
  assert(!stage.empty());
  close();
  stage_ = stage;
  forget_peak();
  begin_s_ = now_s();
  on_progress_(stage, 0);
}

std::vector<StageCost> StageTimer::finish() {
  close();
  return std::exchange(costs_, {});
}

void StageTimer::close() {
  if (stage_.empty()) return;
  costs_.push_back({std::exchange(stage_, {}), now_s() - begin_s_, peak_resident_bytes()});
}

}  // namespace citykiln
