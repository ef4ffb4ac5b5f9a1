// files.json: the list of what a run wrote into its folder, and the comparison of a folder with its list.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

inline constexpr const char* kFileListName = "files.json";
inline constexpr const char* kStagingName = ".new";  ///< The folder of a run in progress (output_folder.h).

struct ListedFile {
  std::string name;  ///< Relative to the folder, "glb/0_0_L1.glb".
  /// Size, and content_hash() as text. Empty for a file whose bytes differ between equal runs (times): only its
  /// presence is checked.
  std::uint64_t bytes = 0;
  std::string hash{};
  bool operator==(const ListedFile&) const = default;
};

/// Sorted by name. The list does not contain files.json itself.
using FileList = std::vector<ListedFile>;

/// The list as JSON: {"files": [{"name": …, "bytes": …, "hash": …}, …]}, one file a line. Deterministic.
std::string file_list_json(const FileList& list);

/// Reads a list. Errors: a file that is no list, or a name that leads out of the folder ("../x", "/x").
/// @return Nothing if there is no such file.
Result<std::optional<FileList>> read_file_list(const std::string& path);

/// What is wrong with a folder. Names in each are sorted.
struct FolderState {
  std::vector<std::string> missing;  ///< Listed, but not there.
  std::vector<std::string> changed;  ///< Listed with another size or hash.
  std::vector<std::string> strange;  ///< Not listed. Folders end in "/".
};

/// Compares a folder with a list by reading every listed file. Strange files are looked for in the folder and in the
/// folders of listed files, not deeper.
/// @param threads  Of reading; 0: all processors.
FolderState compare_folder(const std::string& folder, const FileList& list, int threads);

/// The names that are not listed, looked for as in compare_folder(). Reads no file.
std::vector<std::string> strange_files(const std::string& folder, const FileList& list);

/// Whether a file has the size and hash of its entry.
bool is_whole(const std::string& folder, const ListedFile& file);

}  // namespace citykiln::exporters
