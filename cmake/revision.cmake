# Run by each build (cmake -P): write OUTPUT, the header with the revision of the checkout SOURCE. A file that is right
# already is left alone, so that nothing is compiled again. "-dirty": tracked files differ from the revision; "unknown":
# no checkout or no git.

set(RIFFLE_REVISION "")
find_program(git git)
# A source archive unpacked inside the checkout of something else has no .git of its own.
if(git AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${git} --no-optional-locks describe --always --abbrev=12 --dirty --exclude=*
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE RIFFLE_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT RIFFLE_REVISION)
  set(RIFFLE_REVISION unknown)
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/riffle_revision.hpp.in ${OUTPUT} @ONLY)
