#include "exporters/output_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "compiler/contract/texts/parse.h"
#include "exporters/finish_commit.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {

using OrderedJson = nlohmann::ordered_json;

std::string journal_line(const StagedFile& staged) {
  const OrderedJson json = {{"name", staged.file.name},
                            {"bytes", staged.file.bytes},
                            {"hash", staged.file.hash},
                            {"key", staged.key},
                            {"note", staged.note}};
  return json.dump() + "\n";
}

std::map<std::string, StagedFile> read_journal(const std::string& text) {
  std::map<std::string, StagedFile> files;
  for (const std::string_view line : split(text, '\n')) {
    try {
      const OrderedJson json = OrderedJson::parse(line);
      const std::string name = json.at("name");
      files[name] = {{name, json.at("bytes"), json.at("hash")}, json.at("key"), json.at("note")};
    } catch (const nlohmann::json::exception&) {
      // a torn line
    }
  }
  return files;
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kJournalName = "journal";

Error folder_error(const std::string& path, const char* what) {
  return {path, what + (": " + std::generic_category().message(errno))};
}

/// The journal of an earlier run, as text; empty if there is none.
std::string journal_text(const std::string& path) {
  const Result<std::vector<std::byte>> bytes = read_file(path);
  return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : std::string();
}

}  // namespace

Result<Done> append(GrowingOutput& output, std::span<const std::byte> bytes) {
  output.hash.add(bytes), output.bytes += bytes.size();
  return output.file.append(bytes);
}

Result<OutputFolder> OutputFolder::open(const std::string& path, TakesOver takes_over) {
  OutputFolder folder(path);
  folder.takes_over_ = takes_over;
  if (const Result<Done> made = folder.make_folder(path); !made) return made.error();
  if (access(path.c_str(), W_OK | X_OK) != 0) return folder_error(path, "cannot be written");
  const Result<int> lock = lock_folder(path, false);
  if (!lock) return lock.error();
  if (*lock < 0) return Error{path, "another run is being written into this folder"};
  folder.lock_ = *lock;
  if (const Result<Done> done = finish_commit_locked(path); !done) return done.error();
  if (const Result<Done> done = folder.begin(); !done) return done.error();
  return folder;
}

Result<Done> OutputFolder::begin() {
  staging_ = (fs::path(path_) / kStagingName).string();
  if (Result<Done> made = make_folder(staging_); !made) return made;
  const std::string path = staging_ + "/" + kJournalName, text = journal_text(path);
  staged_ = read_journal(text);
  if (takes_over_ == TakesOver::kFinished) finished_ = read_journal(journal_text(path_ + "/" + kKeysName));
  journal_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (journal_ < 0) return folder_error(path_, "cannot be written");
  // ends a torn line
  if (!text.empty() && text.back() != '\n' && ::write(journal_, "\n", 1) != 1)
    return folder_error(path, "cannot be written");
  return Done{};
}

OutputFolder::OutputFolder(OutputFolder&& other) noexcept
    : path_(std::move(other.path_)),
      staging_(std::move(other.staging_)),
      made_folders_(std::move(other.made_folders_)),
      staged_(std::move(other.staged_)),
      finished_(std::move(other.finished_)),
      files_(std::move(other.files_)),
      takes_over_(other.takes_over_),
      lock_(std::exchange(other.lock_, -1)),
      journal_(std::exchange(other.journal_, -1)),
      is_open_(std::exchange(other.is_open_, false)) {}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (is_open_ && !has_keyed_files()) {
    if (!staging_.empty()) fs::remove_all(staging_, ignored);
    // folders last made first; one that holds something else stays
    for (auto made = made_folders_.rbegin(); made != made_folders_.rend(); ++made) fs::remove(*made, ignored);
  }
  for (const int descriptor : {journal_, lock_})
    if (descriptor >= 0) ::close(descriptor);
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

const StagedFile* OutputFolder::find_whole(const std::string& name, std::uint64_t key) const {
  assert(key != 0);
  const auto is_in = [&](const std::map<std::string, StagedFile>& files, const std::string& folder) {
    const auto found = files.find(name);
    return found != files.end() && found->second.key == key && is_whole(folder, found->second.file) ? &found->second
                                                                                                    : nullptr;
  };
  const StagedFile* staged = is_in(staged_, staging_);
  return staged != nullptr ? staged : is_in(finished_, path_);
}

Result<Done> OutputFolder::take_over(const StagedFile& staged) {
  const auto finished = finished_.find(staged.file.name);
  if (finished == finished_.end() || &finished->second != &staged) {
    files_[staged.file.name] = staged.file;
    return Done{};
  }
  if (Result<Done> done = adopt(staged.file, path_ + "/" + staged.file.name); !done) return done;
  return note_whole(staged);
}

/// Returns the path of a file in .new, whose folder it makes.
Result<std::string> OutputFolder::staged_path(const std::string& name) {
  assert(is_open_ && name != kFileListName && name != kJournalName);
  const fs::path file = fs::path(staging_) / name;
  if (const Result<Done> made = make_folder(file.parent_path().string()); !made) return made.error();
  return file.string();
}

Result<Done> OutputFolder::stage(const std::string& name, std::span<const std::byte> bytes) {
  const Result<std::string> path = staged_path(name);
  if (!path) return path.error();
  return write_file(*path, bytes);
}

Result<Done> OutputFolder::write(const std::string& name, std::span<const std::byte> bytes, std::uint64_t key,
                                 const std::string& note) {
  if (Result<Done> done = stage(name, bytes); !done) return done;
  return note_whole({{name, bytes.size(), hash_text(content_hash(bytes))}, key, note});
}

Result<Done> OutputFolder::note_whole(const StagedFile& staged) {
  const std::string line = journal_line(staged);
  if (::write(journal_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    return folder_error(staging_ + "/" + kJournalName, "cannot be written");
  // this run does not read its own notes
  files_[staged.file.name] = staged.file, staged_[staged.file.name] = {staged.file, staged.key, {}};
  return Done{};
}

Result<Done> OutputFolder::write_varying(const std::string& name, std::span<const std::byte> bytes) {
  Result<Done> done = stage(name, bytes);
  if (done) files_[name] = {.name = name};
  return done;
}

// The temporary name is the same in every run: a run goes over what a killed one left.
Result<GrowingOutput> OutputFolder::begin_growing(const std::string& name) {
  const Result<std::string> path = staged_path(name);
  if (!path) return path.error();
  Result<GrowingFile> file = GrowingFile::create(*path, *path + ".part");
  if (!file) return file.error();
  return GrowingOutput{name, std::move(*file)};
}

Result<Done> OutputFolder::finish_growing(GrowingOutput output) {
  if (Result<Done> done = output.file.finish(); !done) return done;
  return note_whole({{output.name, output.bytes, hash_text(output.hash.value())}, 0, {}});
}

Result<Done> OutputFolder::adopt(const ListedFile& file, const std::string& path) {
  const fs::path to = fs::path(staging_) / file.name;
  if (Result<Done> made = make_folder(to.parent_path().string()); !made) return made;
  std::error_code problem;
  fs::remove(to, problem);
  fs::create_hard_link(path, to, problem);
  if (problem) fs::copy_file(path, to, fs::copy_options::overwrite_existing, problem);
  if (problem) return Error{to.string(), "cannot be written: " + problem.message()};
  files_[file.name] = file;
  return Done{};
}

FileList OutputFolder::files() const {
  FileList list;
  for (const auto& [name, file] : files_) list.push_back(file);
  return list;
}

bool OutputFolder::has_keyed_files() const {
  return std::ranges::any_of(staged_, [](const auto& entry) { return entry.second.key != 0; });
}

// A copy: until the list is written, a run that is interrupted needs the journal.
Result<Done> OutputFolder::keep_keys() {
  std::error_code problem;
  fs::copy_file(staging_ + "/" + kJournalName, staging_ + "/" + kKeysName, fs::copy_options::overwrite_existing,
                problem);
  if (problem) return Error{staging_ + "/" + kKeysName, "cannot be written: " + problem.message()};
  files_[kKeysName] = {.name = kKeysName};
  return Done{};
}

Result<Done> OutputFolder::commit() {
  if (takes_over_ == TakesOver::kFinished)
    if (Result<Done> done = keep_keys(); !done) return done;
  const std::string list = file_list_json(files());
  if (Result<Done> done = write_file(staging_ + "/" + kFileListName, bytes_of(list)); !done) return done;
  is_open_ = false;
  return finish_commit_locked(path_);
}

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

}  // namespace citykiln::exporters
