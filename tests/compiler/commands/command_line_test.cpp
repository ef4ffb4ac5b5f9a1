#include "compiler/commands/command_line.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

/// The arguments and state that a verb received.
struct Heard {
  std::vector<std::string> files, numbers;
  bool is_strict = false, has_run = false, was_quiet = false;
};

Verb listening_verb(Heard& heard) {
  return {"listen",
          "hears",
          {{"files", "FILE...", "", true, append_text(heard.files)},
           {"-n,--number", "N", "", true,
            [&heard](const std::string& text) -> Result<Done> {
              if (text == "bad") return Error{"", "expected a number, found \"bad\""};
              heard.numbers.push_back(text);
              return Done{};
            }},
           {"--strict", "", "", false,
            [&heard](const std::string& text) -> Result<Done> {
              heard.is_strict = text == "true";
              return Done{};
            }}},
          [&heard](const Console& console) -> Result<Exit> {
            heard.has_run = true;
            heard.was_quiet = console.is_quiet;
            if (!heard.files.empty() && heard.files.front() == "absent")
              return Error{"absent", "cannot be read,\nnor seen"};
            return heard.is_strict ? Exit::kStrictViolation : Exit::kDone;
          }};
}

struct Outcome {
  int exit;
  std::string errors;
};

Outcome outcome_of(std::vector<const char*> words, Heard& heard) {
  words.insert(words.begin(), "citykiln");
  const std::vector<Verb> verbs = {listening_verb(heard)};
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const int exit = run(verbs, static_cast<int>(words.size()), words.data());
  testing::internal::GetCapturedStdout();
  return {exit, testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, PassesValuesInOrder) {
  Heard heard;
  EXPECT_EQ(outcome_of({"listen", "a", "b", "-n", "1", "--number", "2", "--quiet"}, heard).exit, 0);
  EXPECT_EQ(heard.files, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(heard.numbers, (std::vector<std::string>{"1", "2"}));
  EXPECT_TRUE(heard.was_quiet);
}

TEST(CommandLine, TakesNegativeNumbersAsValues) {
  Heard heard;
  EXPECT_EQ(outcome_of({"listen", "-n", "-3_4", "-n", "-1,-2.5,0"}, heard).exit, 0);
  EXPECT_EQ(heard.numbers, (std::vector<std::string>{"-3_4", "-1,-2.5,0"}));
}

TEST(CommandLine, DoesNotTakeWhatFollowsAnOptionsValue) {
  Heard heard;
  EXPECT_EQ(outcome_of({"listen", "-n", "1", "file"}, heard).exit, 0);
  EXPECT_EQ(heard.files, (std::vector<std::string>{"file"}));
}

TEST(CommandLine, ErrorsAreOneLineThatNamesTheOption) {
  Heard heard;
  const Outcome outcome = outcome_of({"listen", "-n", "bad"}, heard);
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_EQ(outcome.errors, "citykiln: --number: expected a number, found \"bad\"\n");
  EXPECT_FALSE(heard.has_run);
}

TEST(CommandLine, PrintsErrorsWithLineBreaksAsOneLine) {
  Heard heard;
  const Outcome outcome = outcome_of({"listen", "absent"}, heard);
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_EQ(outcome.errors, "citykiln: absent: cannot be read, nor seen\n");
}

TEST(CommandLine, UnknownOptionsAndVerbsAreErrors) {
  for (const std::vector<const char*>& words :
       {std::vector<const char*>{"listen", "--loud"}, std::vector<const char*>{"shout"}, std::vector<const char*>{}}) {
    Heard heard;
    const Outcome outcome = outcome_of(words, heard);
    EXPECT_EQ(outcome.exit, 1);
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_FALSE(heard.has_run);
  }
}

TEST(CommandLine, SuggestsTheNearestVerbOrOption) {
  Heard heard;
  EXPECT_NE(outcome_of({"lisen", "a"}, heard).errors.find("did you mean listen?"), std::string::npos);
  EXPECT_NE(outcome_of({"listen", "--numer=3"}, heard).errors.find("did you mean --number?"), std::string::npos);
  EXPECT_FALSE(heard.has_run);
}

TEST(CommandLine, ReturnsTheExitCodeOfTheVerb) {
  Heard heard;
  EXPECT_EQ(outcome_of({"listen", "--strict"}, heard).exit, 2);
}

TEST(CommandLine, HelpIsNoError) {
  Heard heard;
  EXPECT_EQ(outcome_of({"listen", "--help"}, heard).exit, 0);
  EXPECT_FALSE(heard.has_run);
}

}  // namespace
}  // namespace citykiln::commands
