#include "exporters/output_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "exporters/finish_commit.h"
#include "exporters/run_files.h"
#include "tests/scratch_folder.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

class OutputFolderOfARun : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return root_.at(name); }

  void put(const std::string& name, const std::string& content) const {
    fs::create_directories(fs::path(at(name)).parent_path());
    std::ofstream(at(name), std::ios::binary) << content;
  }

  /// All files below out/, by name.
  Files files() const {
    Files found;
    for (const auto& entry : fs::recursive_directory_iterator(at("out"))) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      found[entry.path().lexically_relative(at("out")).string()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return found;
  }

  /// The files without the list.
  Files products() const {
    Files found = files();
    EXPECT_EQ(found.erase("files.json"), 1u);
    return found;
  }

  void run(const Files& wanted) const {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    ASSERT_TRUE(folder) << to_string(folder.error());
    for (const auto& [name, content] : wanted) ASSERT_TRUE(folder->write(name, bytes_of(content), 1));
    const Result<Done> done = folder->commit();
    ASSERT_TRUE(done) << to_string(done.error());
  }

  const ScratchFolder root_;
};

const Files kOld = {{"glb/0_0_L0.glb", "old fine"}, {"glb/0_0_L1.glb", "old coarse"}, {"report.json", "{}"}};
const Files kNew = {{"glb/0_0_L0.glb", "new"}, {"scene.kiln", "recipes"}, {"report.json", "{1}"}};

TEST_F(OutputFolderOfARun, IsGoneWithAllItMadeWithoutCommit) {
  {
    Result<OutputFolder> folder = OutputFolder::open(at("a/b"));
    ASSERT_TRUE(folder);
    ASSERT_TRUE(folder->write("glb/one.glb", bytes_of("1")));
    EXPECT_TRUE(fs::exists(at("a/b/.new/glb/one.glb")));
  }
  EXPECT_TRUE(fs::is_empty(root_.path()));
}

TEST_F(OutputFolderOfARun, HoldsExactlyTheLastRun) {
  run(kOld);
  EXPECT_EQ(products(), kOld);
  run(kNew);
  EXPECT_EQ(products(), kNew);
  EXPECT_FALSE(fs::exists(at("out/.new")));
}

TEST_F(OutputFolderOfARun, RemovesFoldersThatBecomeEmpty) {
  run(kOld);
  run({{"scene.kiln", "recipes"}});
  EXPECT_FALSE(fs::exists(at("out/glb")));
}

TEST_F(OutputFolderOfARun, IsUntouchedUntilCommit) {
  run(kOld);
  const Files before = files();
  Result<OutputFolder> folder = OutputFolder::open(at("out"));
  ASSERT_TRUE(folder->write("glb/0_0_L0.glb", bytes_of("new")));
  Files now = files();
  std::erase_if(now, [](const auto& file) { return file.first.starts_with(".new/"); });
  EXPECT_EQ(now, before);
}

TEST_F(OutputFolderOfARun, KeepsWhatOthersPutThere) {
  run(kOld);
  put("out/notes.txt", "mine"), put("out/glb/mine.glb", "also mine"), put("out/mine/x", "deep");
  run({{"report.json", "{}"}});
  EXPECT_EQ(products(),
            (Files{{"report.json", "{}"}, {"notes.txt", "mine"}, {"glb/mine.glb", "also mine"}, {"mine/x", "deep"}}));
}

TEST_F(OutputFolderOfARun, RenamesWhatIsInTheWay) {
  put("out/report.json", "mine"), put("out/report.json.old", "mine too"), put("out/glb", "a file, not a folder");
  put("out/scene.kiln/x", "a folder, not a file");
  run(kNew);
  Files expected = kNew;
  expected["report.json.old"] = "mine too", expected["report.json.old2"] = "mine";
  expected["glb.old"] = "a file, not a folder", expected["scene.kiln.old/x"] = "a folder, not a file";
  EXPECT_EQ(products(), expected);
}

TEST_F(OutputFolderOfARun, KeepsAForeignFileWithTheNameOfItsList) {
  put("out/files.json", "not a list");
  run(kOld);
  Files expected = kOld;
  expected["files.json.old"] = "not a list";
  EXPECT_EQ(products(), expected);
}

TEST_F(OutputFolderOfARun, HasFilesThatGrewLikeFilesWrittenAtOnce) {
  run({{"big", "three pieces of text"}});
  const Files at_once = files();
  put("out/.new/big.part", "what a killed run left, longer than the file");
  {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    Result<GrowingOutput> big = folder->begin_growing("big");
    ASSERT_TRUE(big);
    for (const char* piece : {"three ", "pieces ", "of text"}) ASSERT_TRUE(append(*big, bytes_of(piece)));
    EXPECT_TRUE(folder->files().empty());
    ASSERT_TRUE(folder->finish_growing(std::move(*big)));
    ASSERT_TRUE(folder->commit());
  }
  EXPECT_EQ(files(), at_once);
}

TEST_F(OutputFolderOfARun, HasNothingOfAFileThatNeverFinished) {
  Result<OutputFolder> folder = OutputFolder::open(at("out"));
  {
    Result<GrowingOutput> big = folder->begin_growing("big");
    ASSERT_TRUE(append(*big, bytes_of("half")));
    EXPECT_TRUE(fs::exists(at("out/.new/big.part")));
  }
  EXPECT_FALSE(fs::exists(at("out/.new/big.part")));
  ASSERT_TRUE(folder->write("a", bytes_of("1")));
  ASSERT_TRUE(folder->commit());
  EXPECT_EQ(products(), (Files{{"a", "1"}}));
}

TEST_F(OutputFolderOfARun, TakesOverWhatAnInterruptedRunLeftWhole) {
  {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    for (const char* name : {"a", "b", "c", "d"}) ASSERT_TRUE(folder->write(name, bytes_of("content"), 7, "note"));
  }
  put("out/.new/b", "damaged"), put("out/.new/c", "short"), fs::remove(at("out/.new/d"));
  Result<OutputFolder> folder = OutputFolder::open(at("out"));
  const StagedFile* whole = folder->find_whole("a", 7);
  ASSERT_NE(whole, nullptr);
  EXPECT_EQ(whole->note, "note");
  EXPECT_EQ(folder->find_whole("a", 8), nullptr);
  for (const char* name : {"b", "c", "d", "e"}) EXPECT_EQ(folder->find_whole(name, 7), nullptr) << name;
  ASSERT_TRUE(folder->take_over(*whole));
  ASSERT_TRUE(folder->commit());
  EXPECT_EQ(products(), (Files{{"a", "content"}}));
}

TEST_F(OutputFolderOfARun, TakesOverFilesOfTheFinishedRunWhenAsked) {
  const auto open = [&] { return OutputFolder::open(at("out"), TakesOver::kFinished); };
  for (int run = 0; run < 3; ++run) {
    Result<OutputFolder> folder = open();
    const StagedFile* whole = folder->find_whole("a", 7);
    ASSERT_EQ(whole != nullptr, run > 0);
    EXPECT_EQ(whole != nullptr ? whole->note : "note", "note");
    ASSERT_TRUE(whole != nullptr ? folder->take_over(*whole) : folder->write("a", bytes_of("content"), 7, "note"));
    ASSERT_TRUE(folder->write("b", bytes_of("new" + std::to_string(run)), 8 + static_cast<std::uint64_t>(run)));
    ASSERT_TRUE(folder->commit());
    Files made = products();
    made.erase(kKeysName);
    EXPECT_EQ(made, (Files{{"a", "content"}, {"b", "new" + std::to_string(run)}}));
  }
  put("out/a", "damaged");
  EXPECT_EQ(open()->find_whole("a", 7), nullptr);
  EXPECT_EQ(OutputFolder::open(at("out"))->find_whole("b", 10), nullptr) << "not asked for";
}

TEST_F(OutputFolderOfARun, TakesOverFilesOfTheFinishedRunThatAnInterruptedOneTookOver) {
  const auto open = [&] { return OutputFolder::open(at("out"), TakesOver::kFinished); };
  {
    Result<OutputFolder> folder = open();
    ASSERT_TRUE(folder->write("a", bytes_of("content"), 7));
    ASSERT_TRUE(folder->commit());
  }
  {
    Result<OutputFolder> folder = open();
    ASSERT_TRUE(folder->take_over(*folder->find_whole("a", 7)));
    // another key: the file in the folder keeps its bytes until the end
    ASSERT_TRUE(folder->write("a", bytes_of("changed"), 8));
  }
  EXPECT_EQ(products()["a"], "content");
  Result<OutputFolder> folder = open();
  ASSERT_NE(folder->find_whole("a", 8), nullptr);
  ASSERT_TRUE(folder->take_over(*folder->find_whole("a", 8)));
  ASSERT_TRUE(folder->commit());
  EXPECT_EQ(products()["a"], "changed");
}

TEST_F(OutputFolderOfARun, ReadsAJournalWithATornLine) {
  {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    ASSERT_TRUE(folder->write("a", bytes_of("content"), 7));
  }
  std::ofstream(at("out/.new/journal"), std::ios::app) << R"({"name":"b","by)";
  {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    ASSERT_TRUE(folder->write("c", bytes_of("content"), 7));
  }
  Result<OutputFolder> folder = OutputFolder::open(at("out"));
  EXPECT_NE(folder->find_whole("a", 7), nullptr);
  EXPECT_NE(folder->find_whole("c", 7), nullptr);
}

/// Runs `work` in a child process, which ends as if killed: without destructors. Returns whether it came to its end.
bool ends_in_child(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status);
}

// The state after each prefix of the renames and removals of a commit: finish_commit() makes it the whole new run.
TEST_F(OutputFolderOfARun, IsFinishedAfterAnInterruptionOfItsCommit) {
  run(kOld);
  put("out/notes.txt", "mine"), put("out/scene.kiln", "in the way");
  ASSERT_TRUE(ends_in_child([&] {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    for (const auto& [name, content] : kNew)
      if (!folder->write(name, bytes_of(content), 1)) _exit(1);
    // the list is the last thing that is written before the renames
    std::ofstream(at("out/.new/files.json")) << file_list_json(folder->files());
    _exit(0);
  }));
  Files expected = kNew;
  expected["notes.txt"] = "mine", expected["scene.kiln.old"] = "in the way";
  const fs::path whole = at("whole");
  fs::copy(at("out"), whole, fs::copy_options::recursive);
  const std::vector<std::function<void()>> steps = {
      [&] {},
      [&] { fs::rename(at("out/.new/glb/0_0_L0.glb"), at("out/glb/0_0_L0.glb")); },
      [&] { fs::rename(at("out/.new/report.json"), at("out/report.json")); },
      [&] { fs::rename(at("out/scene.kiln"), at("out/scene.kiln.old")); },
      [&] { fs::rename(at("out/.new/scene.kiln"), at("out/scene.kiln")); },
      [&] { fs::remove(at("out/glb/0_0_L1.glb")); }};
  for (std::size_t done = 0; done <= steps.size(); ++done) {
    fs::remove_all(at("out"));
    fs::copy(whole, at("out"), fs::copy_options::recursive);
    for (std::size_t i = 0; i < done; ++i) steps[i]();
    ASSERT_TRUE(finish_commit(at("out")));
    EXPECT_EQ(products(), expected) << done;
    EXPECT_FALSE(fs::exists(at("out/.new"))) << done;
  }
}

TEST_F(OutputFolderOfARun, IsWrittenByOneProcessAtATime) {
  const Result<OutputFolder> folder = OutputFolder::open(at("out"));
  ASSERT_TRUE(folder);
  const Result<OutputFolder> second = OutputFolder::open(at("out"));
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message, "another run is being written into this folder");
  EXPECT_TRUE(fs::exists(at("out/.new")));
}

TEST_F(OutputFolderOfARun, ListsVaryingFilesWithoutHash) {
  {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    ASSERT_TRUE(folder->write_varying("timing.json", bytes_of("1 s")));
    ASSERT_TRUE(folder->commit());
  }
  const auto list = read_file_list(at("out/files.json"));
  ASSERT_TRUE(list && *list);
  EXPECT_EQ(**list, (FileList{{.name = "timing.json"}}));
}

TEST_F(OutputFolderOfARun, CannotBeAFileNorStandWhereNoneCan) {
  std::ofstream(at("file")) << "";
  EXPECT_FALSE(OutputFolder::open(at("file")));
  EXPECT_FALSE(OutputFolder::open(at("file/below")));
  EXPECT_FALSE(OutputFolder::open("/proc/citykiln"));
}

}  // namespace
}  // namespace citykiln::exporters
