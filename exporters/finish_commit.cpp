#include "exporters/finish_commit.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>

#include "exporters/file_list.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;

Error cannot(const char* do_what, const fs::path& path, const std::error_code& problem) {
  return {path.string(), fmt::format("cannot be {}: {}", do_what, problem.message())};
}

std::set<std::string> names_of(const FileList& list) {
  std::set<std::string> names;
  for (const ListedFile& file : list) names.insert(file.name);
  return names;
}

/// Renames what stands at a path to NAME.old, or NAME.old2 … where that is taken.
Result<Done> set_aside(const fs::path& path) {
  std::error_code problem;
  fs::path other = path.string() + ".old";
  for (int n = 2; fs::exists(fs::symlink_status(other, problem)); ++n)
    other = fmt::format("{}.old{}", path.string(), n);
  fs::rename(path, other, problem);
  return problem ? Result<Done>(cannot("renamed", path, problem)) : Done{};
}

/// Makes the folders of a file, and renames what is in the way: a file where a folder is needed, or something at the
/// file's own place that the old list does not name.
Result<Done> clear_way(const fs::path& folder, const fs::path& name, bool is_ours) {
  fs::path at = folder;
  std::error_code problem;
  for (const fs::path& part : name.parent_path()) {
    at /= part;
    if (fs::is_directory(at, problem)) continue;
    if (fs::exists(fs::symlink_status(at, problem)))
      if (Result<Done> done = set_aside(at); !done) return done;
    fs::create_directory(at, problem);
    if (problem) return cannot("created", at, problem);
  }
  const fs::file_status there = fs::symlink_status(folder / name, problem);
  const bool is_replaced = !fs::exists(there) || (is_ours && !fs::is_directory(there));
  return is_replaced ? Result<Done>(Done{}) : set_aside(folder / name);
}

/// Renames a file, or copies it to another file system (a folder of OUT that is a link to another disk).
void move_file(const fs::path& from, const fs::path& to, std::error_code& problem) {
  fs::rename(from, to, problem);
  if (problem != std::errc::cross_device_link) return;
  const fs::path part = to.string() + ".part";
  fs::copy_file(from, part, fs::copy_options::overwrite_existing, problem);
  if (!problem) fs::rename(part, to, problem);
  if (!problem) fs::remove(from, problem);
}

/// Step 3. A file that is not in .new any more was moved before.
Result<Done> move_files(const fs::path& folder, const FileList& list, const std::set<std::string>& old_names) {
  for (const ListedFile& file : list) {
    const fs::path from = folder / kStagingName / file.name;
    std::error_code problem;
    if (!fs::exists(from, problem)) continue;
    if (Result<Done> done = clear_way(folder, file.name, old_names.contains(file.name)); !done) return done;
    move_file(from, folder / file.name, problem);
    if (problem) return cannot("moved into place", folder / file.name, problem);
  }
  return Done{};
}

/// Step 4, and folders that are empty then.
Result<Done> remove_old_files(const fs::path& folder, const std::set<std::string>& old_names,
                              const std::set<std::string>& new_names) {
  for (const std::string& name : old_names) {
    std::error_code problem;
    if (new_names.contains(name)) continue;
    fs::remove(folder / name, problem);
    if (problem) return cannot("removed", folder / name, problem);
    for (fs::path p = fs::path(name).parent_path(); !p.empty(); p = p.parent_path()) {
      if (!fs::remove(folder / p, problem)) break;  // not empty
    }
  }
  return Done{};
}

/// Step 5.
Result<Done> replace_list(const fs::path& folder) {
  std::error_code problem;
  fs::rename(folder / kStagingName / kFileListName, folder / kFileListName, problem);
  if (problem) return cannot("moved into place", folder / kFileListName, problem);
  fs::remove_all(folder / kStagingName, problem);
  return problem ? Result<Done>(cannot("removed", folder / kStagingName, problem)) : Done{};
}

bool is_decided(const fs::path& folder) {
  std::error_code none;
  return fs::exists(folder / kStagingName / kFileListName, none);
}

}  // namespace

Result<Done> finish_commit_locked(const std::string& folder) {
  if (!is_decided(folder)) return Done{};
  const auto list = read_file_list((fs::path(folder) / kStagingName / kFileListName).string());
  if (!list) return list.error();
  const auto old_list = read_file_list((fs::path(folder) / kFileListName).string());
  const std::set<std::string> new_names = names_of(**list);
  // a list that cannot be read names nothing, so that nothing is removed
  const std::set<std::string> old_names = old_list && *old_list ? names_of(**old_list) : std::set<std::string>();
  if (Result<Done> done = move_files(folder, **list, old_names); !done) return done;
  if (Result<Done> done = remove_old_files(folder, old_names, new_names); !done) return done;
  if (!old_list)
    if (Result<Done> done = set_aside(fs::path(folder) / kFileListName); !done) return done;
  return replace_list(folder);
}

Result<Done> finish_commit(const std::string& folder) {
  if (!is_decided(folder)) return Done{};
  const Result<int> lock = lock_folder(folder, true);
  if (!lock) return lock.error();
  Result<Done> done = finish_commit_locked(folder);
  ::close(*lock);
  return done;
}

bool has_unfinished_run(const std::string& folder) {
  std::error_code none;
  return fs::exists(fs::path(folder) / kStagingName, none) && !is_decided(folder);
}

Result<int> lock_folder(const std::string& folder, bool waits) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return cannot("opened", folder, {errno, std::generic_category()});
  int failed = 0;
  do failed = ::flock(descriptor, LOCK_EX | (waits ? 0 : LOCK_NB));
  while (failed != 0 && errno == EINTR);
  if (failed == 0 || errno != EWOULDBLOCK) return descriptor;
  ::close(descriptor);
  return -1;
}

}  // namespace citykiln::exporters
