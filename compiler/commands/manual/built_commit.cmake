# Writes the source of built_commit.h: cmake -DSOURCE=FOLDER -DOUT=FILE -P built_commit.cmake
execute_process(COMMAND git describe --always --tags --abbrev=8 WORKING_DIRECTORY ${SOURCE}
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
# a tarball within another repository is not of its commit
execute_process(COMMAND git rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
                OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(text "")
if(NOT failed AND top STREQUAL SOURCE)
  set(text " (${commit})")
endif()
file(WRITE ${OUT} "#include \"compiler/commands/manual/built_commit.h\"
namespace citykiln::commands {
const char* const kBuiltCommit = \"${text}\";
}
")
