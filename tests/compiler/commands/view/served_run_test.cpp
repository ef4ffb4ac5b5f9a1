#include "compiler/commands/view/served_run.h"

#include <gtest/gtest.h>

#include <string>

namespace citykiln::commands {
namespace {

constexpr int kPort = 8000;
constexpr const char* kHost = "127.0.0.1:8000";

ServedRun served_town() { return {"out/town", {{"index.html", 1}, {"page/viewer.js", 2}, {"3dtiles/0_0_L0.glb", 3}}}; }

TEST(ServedRun, AnswersListedFiles) {
  const ServedRun run = served_town();
  const ServedRun::Answer answer = run.answer(kHost, "/page/viewer.js", kPort);
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(std::string(answer.file), "out/town/page/viewer.js");
  EXPECT_EQ(std::string(run.answer(kHost, "/", kPort).file), "out/town/index.html");
  EXPECT_EQ(run.answer(kHost, "/files.json", kPort).status, 200);
}

TEST(ServedRun, HasNoFileThatIsNotListed) {
  const ServedRun run = served_town();
  for (const char* path :
       {"/page", "/page/", "/timing.json", "//index.html", "/./index.html", "index.html", "", "/.new"})
    EXPECT_EQ(run.answer(kHost, path, kPort).status, 404) << path;
}

TEST(ServedRun, RefusesPathsThatLeadUp) {
  const ServedRun run = served_town();
  for (const char* path : {"/../secret", "/page/../index.html", "/..", "..", "/page/..\\viewer.js"})
    EXPECT_EQ(run.answer(kHost, path, kPort).status, 403) << path;
}

TEST(ServedRun, RefusesOtherHosts) {
  const ServedRun run = served_town();
  EXPECT_EQ(run.answer("localhost:8000", "/", kPort).status, 200);
  for (const char* host : {"", "example.org", "example.org:8000", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:8000.org"})
    EXPECT_EQ(run.answer(host, "/", kPort).status, 403) << host;
}

TEST(ServedRun, MediaTypesAreThoseOfEndings) {
  EXPECT_EQ(std::string(media_type_of("page/viewer.js")), "text/javascript; charset=utf-8");
  EXPECT_EQ(std::string(media_type_of("3dtiles/a.glb")), "model/gltf-binary");
  EXPECT_EQ(std::string(media_type_of("scene.kiln")), "application/octet-stream");
}

}  // namespace
}  // namespace citykiln::commands
