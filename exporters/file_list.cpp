#include "exporters/file_list.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/contract/system/for_each_slot.h"
#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

bool stays_inside(const fs::path& name) {
  const fs::path normal = name.lexically_normal();
  return name.is_relative() && name.has_filename() && name == normal && *normal.begin() != ".." && normal != ".";
}

FileList list_of(const OrderedJson& json) {
  FileList list;
  for (const OrderedJson& file : json.at("files"))
    list.push_back({file.at("name"), file.value("bytes", std::uint64_t{0}), file.value("hash", "")});
  return list;
}

/// The folder, and every folder that holds a listed file: relative names, "" for the folder itself.
std::set<fs::path> folders_of(const FileList& list) {
  std::set<fs::path> folders = {fs::path()};
  for (const ListedFile& file : list)
    for (fs::path p = fs::path(file.name).parent_path(); !p.empty(); p = p.parent_path()) folders.insert(p);
  return folders;
}

}  // namespace

bool has_file(const FileList& list, std::string_view name) {
  return std::ranges::find(list, name, &ListedFile::name) != list.end();
}

std::string file_list_json(const FileList& list) {
  std::string text = "{\"files\": [";
  for (const ListedFile& file : list) {
    OrderedJson json = {{"name", file.name}};
    if (!file.hash.empty()) json["bytes"] = file.bytes, json["hash"] = file.hash;
    text += (text.back() == '[' ? "\n " : ",\n ") + json.dump();
  }
  return text + "\n]}\n";
}

Result<std::optional<FileList>> read_file_list(const std::string& path) {
  std::error_code none;
  if (!fs::exists(path, none)) return std::optional<FileList>();
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) return bytes.error();
  try {
    const char* text = reinterpret_cast<const char*>(bytes->data());
    FileList list = list_of(OrderedJson::parse(text, text + bytes->size()));
    for (const ListedFile& file : list)
      if (!stays_inside(file.name)) return Error{path, "lists \"" + file.name + "\", which is not inside the folder"};
    return std::optional(std::move(list));
  } catch (const nlohmann::json::exception&) {
    return Error{path, "is not a list of files written by citykiln"};
  }
}

bool is_whole(const std::string& folder, const ListedFile& file) {
  const fs::path path = fs::path(folder) / file.name;
  std::error_code bad;
  if (file.hash.empty()) return fs::is_regular_file(path, bad);
  // the size first: it needs no reading
  if (fs::file_size(path, bad) != file.bytes || bad) return false;
  const Result<std::vector<std::byte>> bytes = read_file(path.string());
  return bytes && hash_text(content_hash(*bytes)) == file.hash;
}

std::vector<std::string> unlisted_files(const std::string& folder, const FileList& list) {
  const std::set<fs::path> folders = folders_of(list);
  std::set<fs::path> known = {kFileListName, kStagingName};
  for (const ListedFile& file : list) known.insert(file.name);
  std::vector<std::string> unlisted;
  for (const fs::path& inside : folders) {
    std::error_code bad;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder) / inside, bad)) {
      const fs::path name = inside / entry.path().filename();
      const bool is_folder = entry.is_directory(bad);
      if (known.contains(name) || (is_folder && folders.contains(name))) continue;
      unlisted.push_back(name.string() + (is_folder ? "/" : ""));
    }
  }
  std::ranges::sort(unlisted);
  return unlisted;
}

FolderState compare_folder(const std::string& folder, const FileList& list, int threads) {
  const std::vector<char> whole = for_each_slot<char>(
      list.size(), threads, [&](std::size_t i) { return static_cast<char>(is_whole(folder, list[i])); });
  FolderState state;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (whole[i] != 0) continue;
    std::error_code bad;
    const bool is_there = fs::exists(fs::path(folder) / list[i].name, bad);
    (is_there ? state.changed : state.missing).push_back(list[i].name);
  }
  state.unlisted = unlisted_files(folder, list);
  return state;
}

}  // namespace citykiln::exporters
