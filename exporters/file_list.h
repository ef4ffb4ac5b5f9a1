// files.json: the list of the files that a run wrote into its folder, and the comparison of a folder with its list.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

struct ListedFile {
  std::string name;  ///< The path relative to the folder: "glb/0_0_L1.glb".
  /// Size, and content_hash() as text. The hash is empty for a file whose bytes differ between equal runs, such as
  /// times: only the presence of such a file is checked.
  std::uint64_t bytes = 0;
  std::string hash{};
  bool operator==(const ListedFile&) const = default;
};

/// The files of a run, sorted by name, without files.json itself.
using FileList = std::vector<ListedFile>;

/// True if a list names a file. O(n).
bool has_file(const FileList& list, std::string_view name);

/// Returns the list as JSON, one file a line: {"files": [{"name": …, "bytes": …, "hash": …}, …]}. Deterministic.
std::string file_list_json(const FileList& list);

/// Reads a list. Errors: a file that is not such a list, or a name that leads out of the folder ("../x", "/x").
/// @return std::nullopt if there is no such file.
Result<std::optional<FileList>> read_file_list(const std::string& path);

/// The differences between a folder and its list, sorted by name.
struct FolderState {
  std::vector<std::string> missing;   ///< Listed files that the folder lacks.
  std::vector<std::string> changed;   ///< Files whose size or hash differs from the listed one.
  std::vector<std::string> unlisted;  ///< Files and folders that are not listed. Names of folders end in "/".
};

/// Compares a folder with a list by reading every listed file. Looks for files that are not listed in the folder itself
/// and in the folders of listed files, not deeper.
/// @param threads  The number of threads that read; 0: one per processor.
FolderState compare_folder(const std::string& folder, const FileList& list, int threads);

/// Returns FolderState::unlisted as compare_folder() finds it, but reads no file.
std::vector<std::string> unlisted_files(const std::string& folder, const FileList& list);

/// True if a file exists and, if its entry has a hash, has the size and the hash of the entry.
bool is_whole(const std::string& folder, const ListedFile& file);

}  // namespace citykiln::exporters
