#include "exporters/output_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "exporters/file.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "report.json";

}  // namespace

Result<OutputFolder> OutputFolder::open(const std::string& path) {
  OutputFolder folder(path);
  if (const Result<Done> made = folder.make_folder(path); !made) return made.error();
  if (access(path.c_str(), W_OK | X_OK) != 0) {
    return Error{path, "cannot be written: " + std::generic_category().message(errno)};
  }
  std::error_code problem;
  fs::remove(fs::path(path) / kMark, problem);
  if (problem) return Error{path, "the report of an earlier run cannot be removed: " + problem.message()};
  return folder;
}

OutputFolder::OutputFolder(OutputFolder&& other) noexcept
    : path_(std::move(other.path_)),
      made_folders_(std::move(other.made_folders_)),
      made_files_(std::move(other.made_files_)),
      is_open_(std::exchange(other.is_open_, false)) {}

OutputFolder::~OutputFolder() {
  if (!is_open_) return;
  std::error_code ignored;
  for (const std::string& file : made_files_) fs::remove(file, ignored);
  // folders last made first; one that holds what is not ours stays
  for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder) fs::remove(*folder, ignored);
}

Result<Done> OutputFolder::make_folder(const std::string& path) {
  std::vector<fs::path> missing;
  std::error_code problem;
  for (fs::path p = fs::path(path).lexically_normal(); !p.empty() && !fs::exists(p, problem); p = p.parent_path())
    missing.push_back(p);
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
    if (fs::create_directory(*folder, problem)) made_folders_.push_back(folder->string());
    if (problem) return Error{path, "cannot be created: " + problem.message()};
  }
  if (!fs::is_directory(path, problem)) return Error{path, "is not a folder"};
  return Done{};
}

Result<Done> OutputFolder::write(const std::string& name, std::span<const std::byte> bytes) {
  assert(is_open_);
  const fs::path file = fs::path(path_) / name;
  if (Result<Done> made = make_folder(file.parent_path().string()); !made) return made;
  Result<Done> written = exporters::write_file(file.string(), bytes);
  if (written) made_files_.push_back(file.string());
  return written;
}

Result<Done> OutputFolder::commit(const std::string& report_json) {
  Result<Done> written = write(kMark, bytes_of(report_json));
  is_open_ = !written;
  return written;
}

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

}  // namespace citykiln::exporters
