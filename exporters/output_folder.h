// The output folder of a run. A new run replaces an earlier one in such a way that the folder never holds half a run.
//
//     OUT/files.json         the list: name, size and hash of every file of the finished run
//     OUT/scene.kiln …       its files
//     OUT/.new/              the files of the run in progress, by their final names, and two files about it:
//     OUT/.new/journal         a line for each file that is whole: name, size, hash, key, note
//     OUT/.new/files.json      the new list; written when all files are whole
//
//     step                                              if the process ends here
//     1. write files into .new, a journal line each     OUT is as before; a run with equal keys takes over whole files
//     2. write .new/files.json                          -
//     3. rename each file of the new list into OUT      finish_commit() (finish_commit.h) does steps 3 to 5 again
//     4. remove files that only the old list names      as in step 3
//     5. rename .new/files.json to OUT, remove .new     as in step 3
//
// With TakesOver::kFinished the run leaves its journal in OUT as keys.jsonl, a listed file. The next such run reuses
// the files with equal keys, by hard links in .new.
//
// Only files that a list names are replaced or removed. Any other file that is in the way is renamed to NAME.old. The
// key of a file is a hash of all inputs that determine its bytes: equal keys mean equal bytes.
//
// The renames need no disk space, and all writing happens before step 2, so a full disk leaves OUT as it was. Files are
// not flushed to the disk: after a power failure the hashes show which files are complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/file_list.h"

namespace citykiln::exporters {

// The journal of a run in progress: one line of JSON for each complete file, appended after the file has its final
// name. A process may end at any moment: readers skip a last line that is incomplete.

/// A complete file of a run in progress.
struct StagedFile {
  ListedFile file;
  /// A hash of all inputs that determine the bytes. 0: there is no key, so later runs cannot reuse the file.
  std::uint64_t key = 0;
  std::string note;  ///< Facts about the file for a run that reuses it, UTF-8.
};

/// Returns the line of a file, with the line feed.
std::string journal_line(const StagedFile& staged);

/// Returns the files of a journal by name; the last line of a name counts. Skips lines that are not entries, so it
/// accepts any text.
std::map<std::string, StagedFile> read_journal(const std::string& text);

/// The earlier runs whose files a run may reuse. kInterrupted: an interrupted run. kFinished: also the finished run in
/// the folder; the new run then leaves its own keys for the next.
enum class TakesOver { kInterrupted, kFinished };

/// A file of a run that is written piece by piece, so that it is never in memory.
struct GrowingOutput {
  std::string name;  ///< The path relative to the folder.
  GrowingFile file;
  ContentHasher hash{};
  std::uint64_t bytes = 0;
};

/// Writes bytes at the end of a file. Error: a file that cannot be written.
Result<Done> append(GrowingOutput& output, std::span<const std::byte> bytes);

/// Writes the files of one run. An object destroyed without commit() leaves OUT as it was. If .new holds files with
/// keys, .new stays for the next run; else .new is removed, together with the folders that were made.
class OutputFolder {
 public:
  /// Opens a folder: makes it if it is missing, and finishes an interrupted commit. Errors: a folder that cannot be
  /// made or written; another process that is writing a run into it.
  static Result<OutputFolder> open(const std::string& path, TakesOver takes_over = TakesOver::kInterrupted);
  ~OutputFolder();
  OutputFolder(OutputFolder&& other) noexcept;
  OutputFolder& operator=(OutputFolder&&) = delete;
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Returns the complete file with this name and key that an earlier run left, after verifying its hash; else null.
  /// May be called from several threads while nothing is written.
  ///
  /// @param key  Not 0.
  const StagedFile* find_whole(const std::string& name, std::uint64_t key) const;
  /// Adds a file that find_whole() returned to this run. Error of this and the next functions: a file that cannot be
  /// written.
  Result<Done> take_over(const StagedFile& staged);

  /// Writes a file of this run.
  ///
  /// @param name  The path relative to the folder: "glb/0_0_L1.glb".
  /// @param key   A hash of all inputs that determine the bytes; 0: later runs cannot reuse the file.
  /// @param note  Facts about the file for a run that reuses it, UTF-8.
  Result<Done> write(const std::string& name, std::span<const std::byte> bytes, std::uint64_t key = 0,
                     const std::string& note = {});
  /// Writes a file whose bytes differ between equal runs, such as times.
  Result<Done> write_varying(const std::string& name, std::span<const std::byte> bytes);

  /// Begins a file that grows (append()). It is a file of this run only once it is finished; if it never is, nothing
  /// stays of it.
  Result<GrowingOutput> begin_growing(const std::string& name);
  /// Adds a file that grew to this run. Later runs cannot reuse it.
  Result<Done> finish_growing(GrowingOutput output);

  /// Adds a complete file from elsewhere to this run, by a hard link, or by a copy if that fails (another file system).
  Result<Done> adopt(const ListedFile& file, const std::string& path);

  /// Returns the files written or added until now, sorted by name.
  FileList files() const;
  /// True if a later run can reuse files should this one end without commit().
  bool has_keyed_files() const;
  /// True if an earlier run left files that this one can reuse.
  bool has_earlier_files() const { return has_keyed_files() || !finished_.empty(); }

  /// Replaces the earlier run by this one: steps 2 to 5. Errors: files that cannot be written, moved or removed.
  /// Nothing may be written afterwards.
  Result<Done> commit();

 private:
  explicit OutputFolder(std::string path) : path_(std::move(path)) {}
  Result<Done> make_folder(const std::string& path);
  Result<Done> begin();
  Result<std::string> staged_path(const std::string& name);
  Result<Done> stage(const std::string& name, std::span<const std::byte> bytes);
  Result<Done> note_whole(const StagedFile& staged);
  Result<Done> keep_keys();

  std::string path_, staging_;
  std::vector<std::string> made_folders_;
  std::map<std::string, StagedFile> staged_;    ///< By name: complete files of an interrupted run and of this run.
  std::map<std::string, StagedFile> finished_;  ///< By name: files of the finished run in the folder.
  std::map<std::string, ListedFile> files_;     ///< By name: files of this run.
  TakesOver takes_over_ = TakesOver::kInterrupted;
  int lock_ = -1, journal_ = -1;  ///< File descriptors.
  bool is_open_ = true;           ///< False once committed or moved from.
};

/// Views a text as bytes.
std::span<const std::byte> bytes_of(const std::string& text);

}  // namespace citykiln::exporters
