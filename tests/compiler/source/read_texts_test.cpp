#include "compiler/source/read_texts.h"

#include <gtest/gtest.h>

#include "tests/scratch_folder.h"

namespace citykiln::source {
namespace {

TEST(ReadTexts, AByteOrderMarkIsNoText) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.cga", "\xef\xbb\xbfversion \"2013.1\"\n");
  folder.write("b.cga", "Lot --> X\n");
  const Result<std::vector<TextFile>> texts = read_texts(path.substr(0, path.rfind('/')), ".cga");
  ASSERT_TRUE(texts);
  ASSERT_EQ(texts->size(), 2u);
  EXPECT_EQ((*texts)[0].text, "version \"2013.1\"\n");
  EXPECT_EQ((*texts)[1].text, "Lot --> X\n");
}

}  // namespace
}  // namespace citykiln::source
