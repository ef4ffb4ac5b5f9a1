#include "exporters/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

#include "exporters/gltf/glb.h"
#include "exporters/kiln/manifest.h"
#include "tests/exporters/made_scene.h"
#include "tests/exporters/made_tile.h"
#include "tests/scratch_folder.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytes_of_text(const std::string& text) {
  const auto span = std::as_bytes(std::span(text));
  return {span.begin(), span.end()};
}
template <typename T>
std::string message_of(const Result<T>& result) {
  return result ? "done" : to_string(result.error());
}

class File : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.at(name); }
  std::set<std::string> names() const { return folder_.names(); }

  const ScratchFolder folder_;
};

// Limits files to `bytes` bytes, as a full disk would. Only for the child of a death test.
void fill_disk(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}
// Ends the child of a death test with a message.
[[noreturn]] void say(const std::string& words) {
  std::cerr << words << std::endl;
  std::_Exit(0);
}

TEST_F(File, ReadsBackWhatItWrote) {
  for (const std::string& text : {std::string(), std::string("clay"), std::string(1 << 20, 'x')}) {
    ASSERT_EQ(message_of(write_file(at("a"), bytes_of_text(text))), "done");
    const auto back = read_file(at("a"));
    ASSERT_TRUE(back) << message_of(back);
    EXPECT_EQ(*back, bytes_of_text(text));
    EXPECT_EQ(names(), std::set<std::string>{"a"});
  }
}

TEST_F(File, AFolderThatIsNotThereIsNamed) {
  EXPECT_EQ(message_of(write_file(at("no/a"), bytes_of_text("x"))),
            at("no/a") + ": cannot be created: No such file or directory");
}

TEST_F(File, AFolderThatMayNotBeWrittenIsNamed) {
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  // root may write everywhere, so it steps down for this one
  const auto attempt = [&] {
    if (::geteuid() == 0 && (::chown(folder_.path().c_str(), 65534, 65534) != 0 || ::seteuid(65534) != 0))
      say("still root");
    say(message_of(write_file(at("a"), bytes_of_text("x"))));
  };
  EXPECT_EXIT(attempt(), testing::ExitedWithCode(0), "/a: cannot be created: Permission denied");
  EXPECT_EQ(names(), std::set<std::string>{});
}

TEST_F(File, AFullDiskLeavesNothing) {
  const auto attempt = [&] {
    fill_disk(4096);
    say(message_of(write_file(at("a"), bytes_of_text(std::string(10000, 'x')))));
  };
  EXPECT_EXIT(attempt(), testing::ExitedWithCode(0), "/a: cannot be written: File too large");
  EXPECT_EQ(names(), std::set<std::string>{});
}

TEST_F(File, AFullDiskLeavesTheFileThatWasThere) {
  ASSERT_TRUE(write_file(at("a"), bytes_of_text("before")));
  const auto attempt = [&] {
    fill_disk(4096);
    say(message_of(write_file(at("a"), bytes_of_text(std::string(10000, 'x')))));
  };
  EXPECT_EXIT(attempt(), testing::ExitedWithCode(0), "/a: cannot be written");
  EXPECT_EQ(names(), std::set<std::string>{"a"});
  EXPECT_EQ(*read_file(at("a")), bytes_of_text("before"));
}

TEST_F(File, AFullDiskEndsManifestAndTileWithTheirNames) {
  const auto manifest = [&] {
    fill_disk(100);
    say(message_of(write_file(at("scene.kiln"), encode_manifest(SceneMaker(1).scene(), 1))));
  };
  const auto tile = [&] {
    fill_disk(100);
    say(message_of(write_glb(made_tile(1), {}, {}, at("tile.glb"))));
  };
  EXPECT_EXIT(manifest(), testing::ExitedWithCode(0), "/scene.kiln: cannot be written");
  EXPECT_EXIT(tile(), testing::ExitedWithCode(0), "/tile.glb: cannot be written");
  EXPECT_EQ(names(), std::set<std::string>{});
}

TEST_F(File, AFolderUnderTheFinalNameStays) {
  fs::create_directory(at("a"));
  EXPECT_EQ(message_of(write_file(at("a"), bytes_of_text("x"))), at("a") + ": cannot be written: Is a directory");
  EXPECT_EQ(names(), std::set<std::string>{"a"});
}

TEST_F(File, WhatCannotBeReadIsNamed) {
  EXPECT_EQ(message_of(read_file(at("none"))), at("none") + ": cannot be opened: No such file or directory");
  EXPECT_EQ(message_of(read_file(folder_.path())), folder_.path() + ": expected a file, found a folder");
  EXPECT_EQ(message_of(read_manifest(at("none"), {})), at("none") + ": cannot be opened: No such file or directory");
  EXPECT_EQ(message_of(read_glb(at("none"))), at("none") + ": cannot be opened: No such file or directory");
}

TEST_F(File, APipeIsRefused) {
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  // opens both ends, so that neither blocks
  const std::fstream ends(at("pipe"));
  EXPECT_EQ(message_of(read_file(at("pipe"))), at("pipe") + ": cannot be opened: Illegal seek");
}

}  // namespace
}  // namespace citykiln::exporters
