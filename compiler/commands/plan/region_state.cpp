#include "compiler/commands/plan/region_state.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "exporters/file.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string path_of(const std::string& plan_folder, regions::RegionKey region) {
  return plan_folder + "/state/" + to_string(region) + ".json";
}

std::string host_name() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

TaskState state_named(const std::string& name) {
  for (const TaskState state : {TaskState::kRunning, TaskState::kFailed, TaskState::kDone})
    if (name == name_of(state)) return state;
  return TaskState::kWaiting;
}

bool is_gone(const RegionState& state) {
  return state.host == host_name() && kill(static_cast<pid_t>(state.process), 0) != 0 && errno == ESRCH;
}

RegionState state_of(const OrderedJson& json) {
  RegionState state{.state = state_named(json.at("state")),
                    .key = json.at("key"),
                    .error = json.at("error"),
                    .host = json.at("host"),
                    .process = json.at("process"),
                    .seconds = json.at("seconds"),
                    .memory_bytes = json.at("memory_bytes"),
                    .output_bytes = json.at("output_bytes")};
  if (state.state == TaskState::kRunning && is_gone(state)) state.state = TaskState::kInterrupted;
  return state;
}

}  // namespace

std::string_view name_of(TaskState state) {
  constexpr std::string_view kNames[] = {"waiting", "running", "interrupted", "failed", "done"};
  return kNames[static_cast<int>(state)];
}

RegionState read_state(const std::string& plan_folder, regions::RegionKey region) {
  std::ifstream file(path_of(plan_folder, region), std::ios::binary);
  if (!file) return {};
  try {
    return state_of(OrderedJson::parse(file));
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

Result<Done> write_state(const std::string& plan_folder, regions::RegionKey region, RegionState state) {
  const OrderedJson json = {{"state", name_of(state.state)},
                            {"key", state.key},
                            {"error", state.error},
                            {"host", host_name()},
                            {"process", getpid()},
                            {"seconds", state.seconds},
                            {"memory_bytes", state.memory_bytes},
                            {"output_bytes", state.output_bytes}};
  const std::string text = json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
  std::error_code none;
  std::filesystem::create_directories(plan_folder + "/state", none);
  return exporters::write_file(path_of(plan_folder, region), exporters::bytes_of(text));
}

void lock_until_exit(const std::string& plan_folder, regions::RegionKey region) {
  std::error_code none;
  std::filesystem::create_directories(plan_folder + "/state", none);
  const std::string path = plan_folder + "/state/." + to_string(region) + ".lock";
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  while (descriptor >= 0 && ::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
  }
}

}  // namespace citykiln::commands
