#include "exporters/file_list.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "exporters/content_hash.h"
#include "tests/scratch_folder.h"

namespace citykiln::exporters {
namespace {

using Names = std::vector<std::string>;

ListedFile listed(const std::string& name, const std::string& content) {
  return {name, content.size(), hash_text(content_hash(content))};
}

TEST(FileList, ReadsBackWhatItWrote) {
  const FileList list = {listed("glb/0_0_L0.glb", "tile"), {.name = "timing.json"}};
  const ScratchFolder folder;
  const auto back = read_file_list(folder.write("files.json", file_list_json(list)));
  ASSERT_TRUE(back && *back);
  EXPECT_EQ(**back, list);
  EXPECT_FALSE(*read_file_list(folder.at("none.json")));
}

TEST(FileList, NamesOnlyFilesInsideTheFolder) {
  const ScratchFolder folder;
  for (const char* name : {"../secret", "/etc/passwd", "glb/../../secret", "", ".", "glb/.", "glb/"})
    EXPECT_FALSE(read_file_list(folder.write("files.json", file_list_json({{.name = name}})))) << name;
}

TEST(FileList, RefusesOtherFiles) {
  const ScratchFolder folder;
  for (const char* text : {"", "{}", "[]", R"({"files": 3})", R"({"files": [{}]})", R"({"files": [{"name": 4}]})"})
    EXPECT_FALSE(read_file_list(folder.write("files.json", text))) << text;
}

TEST(FileList, FindsWhatIsMissingChangedAndStrange) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.at("glb"));
  std::filesystem::create_directories(folder.at("mine/deep"));
  const FileList list = {listed("glb/a", "aaaa"),
                         listed("glb/b", "bbbb"),
                         listed("glb/c", "cccc"),
                         listed("gone/d", "dddd"),
                         {.name = "timing.json"}};
  folder.write("glb/a", "aaaa"), folder.write("glb/b", "bbbB"), folder.write("glb/c", "ccc");
  folder.write("glb/stranger", ""), folder.write("notes.txt", ""), folder.write("timing.json", "any");
  folder.write("files.json", file_list_json(list)), folder.write("mine/deep/x", "");
  const FolderState state = compare_folder(folder.path(), list, 2);
  EXPECT_EQ(state.missing, (Names{"gone/d"}));
  EXPECT_EQ(state.changed, (Names{"glb/b", "glb/c"}));
  EXPECT_EQ(state.unlisted, (Names{"glb/stranger", "mine/", "notes.txt"}));
}

}  // namespace
}  // namespace citykiln::exporters
