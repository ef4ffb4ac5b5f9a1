// The program: hands the command line to its verbs. What a compile does is told by pipeline.cpp.
#include <array>
#include <csignal>

#include "compiler/commands/command_line.h"

int main(int argc, char** argv) {
  using namespace citykiln::commands;
  // a file that may not grow is an error of writing, with one line, not the end of the process
  std::signal(SIGXFSZ, SIG_IGN);
  const std::array verbs = {compile_verb(), bake_verb(), preview_verb(), inspect_verb(), check_verb(), chart_verb()};
  return run(verbs, argc, argv);
}
