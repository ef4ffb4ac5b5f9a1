// PLAN/state/X_Y.json: how the task of a region stands.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/contract/result.h"
#include "compiler/regions/region.h"

namespace citykiln::commands {

/// kWaiting: no task began. kInterrupted: a task of this machine began and is gone without an end.
enum class TaskState { kWaiting, kRunning, kInterrupted, kFailed, kDone };
std::string_view name_of(TaskState state);  ///< "waiting", "running", …

struct RegionState {
  TaskState state = TaskState::kWaiting;
  std::string key;    ///< Of what the outputs are a function; see region_key().
  std::string error;  ///< One line, of a failed task.
  std::string host;
  std::int64_t process = 0;
  double seconds = 0;
  std::uint64_t memory_bytes = 0, output_bytes = 0;  ///< Largest resident memory; size of all outputs.
};

/// Reads the state of a region. A file that is missing or broken means kWaiting.
RegionState read_state(const std::string& plan_folder, regions::RegionKey region);

/// Writes the state with the host and process of the caller.
Result<Done> write_state(const std::string& plan_folder, regions::RegionKey region, RegionState state);

/// Locks a region against other tasks until this process ends, and waits for one that has it locked: a task whose node
/// or Slurm step is gone may run on while its successor begins. Does nothing on file systems without locks.
void lock_until_exit(const std::string& plan_folder, regions::RegionKey region);

}  // namespace citykiln::commands
