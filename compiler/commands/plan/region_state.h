// PLAN/state/X_Y.json: the state of the task that compiles region X_Y of a plan.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/contract/result.h"
#include "compiler/regions/region.h"

namespace citykiln::commands {

/// kWaiting: no task has begun. kInterrupted: a task on this machine began, and its process ended without a result.
enum class TaskState { kWaiting, kRunning, kInterrupted, kFailed, kDone };
std::string_view name_of(TaskState state);  ///< "waiting", "running", …

/// The contents of the file.
struct RegionState {
  TaskState state = TaskState::kWaiting;
  std::string key;    ///< A hash of everything that the outputs depend on; see region_key().
  std::string error;  ///< The error of a failed task, in one line.
  std::string host;   ///< Machine and process of the task.
  std::int64_t process = 0;
  double seconds = 0;
  std::uint64_t memory_bytes = 0, output_bytes = 0;  ///< Largest resident memory; size of all outputs.
};

/// Reads the state of a region. A file that is missing or broken means kWaiting.
RegionState read_state(const std::string& plan_folder, regions::RegionKey region);

/// Writes the state with the host and process of the caller. Error: a file that cannot be written.
Result<Done> write_state(const std::string& plan_folder, regions::RegionKey region, RegionState state);

/// Locks a region against other tasks until this process ends, and waits for a task that has locked it. A task whose
/// machine or Slurm step was given up can still run when its successor begins. Does nothing on file systems without
/// locks.
void lock_until_exit(const std::string& plan_folder, regions::RegionKey region);

}  // namespace citykiln::commands
