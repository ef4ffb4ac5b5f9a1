#include "exporters/output_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/scratch_folder.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;

class OutputFolderOfARun : public testing::Test {
 protected:
  std::string at(const char* name) const { return root_.at(name); }
  const ScratchFolder root_;
};

TEST_F(OutputFolderOfARun, IsGoneWithAllItMadeWithoutCommit) {
  {
    Result<OutputFolder> folder = OutputFolder::open(at("a/b"));
    ASSERT_TRUE(folder);
    ASSERT_TRUE(folder->write("glb/one.glb", bytes_of("1")));
    EXPECT_TRUE(fs::exists(at("a/b/glb/one.glb")));
  }
  EXPECT_TRUE(fs::is_empty(root_.path()));
}

TEST_F(OutputFolderOfARun, StaysWithItsReportAfterCommit) {
  {
    Result<OutputFolder> folder = OutputFolder::open(at("out"));
    ASSERT_TRUE(folder->write("glb/one.glb", bytes_of("1")));
    ASSERT_TRUE(folder->commit("{}"));
  }
  EXPECT_TRUE(fs::exists(at("out/glb/one.glb")));
  EXPECT_TRUE(fs::exists(at("out/report.json")));
}

TEST_F(OutputFolderOfARun, KeepsWhatOthersPutThere) {
  fs::create_directory(at("out"));
  std::ofstream(at("out/notes.txt")) << "mine";
  { ASSERT_TRUE(OutputFolder::open(at("out"))); }
  EXPECT_TRUE(fs::exists(at("out/notes.txt")));
}

TEST_F(OutputFolderOfARun, LosesTheMarkOfTheRunBeforeAtOnce) {
  fs::create_directory(at("out"));
  std::ofstream(at("out/report.json")) << "{}";
  const Result<OutputFolder> folder = OutputFolder::open(at("out"));
  ASSERT_TRUE(folder);
  EXPECT_FALSE(fs::exists(at("out/report.json")));
}

TEST_F(OutputFolderOfARun, CannotBeAFileNorStandWhereNoneCan) {
  std::ofstream(at("file")) << "";
  EXPECT_FALSE(OutputFolder::open(at("file")));
  EXPECT_FALSE(OutputFolder::open(at("file/below")));
  EXPECT_FALSE(OutputFolder::open("/proc/citykiln"));
}

}  // namespace
}  // namespace citykiln::exporters
