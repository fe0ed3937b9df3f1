# Keeps <build>/generated/commit.hpp up to date with the commit that is being built.
# Included by CMakeLists.txt after the modules; run again by every build as a script. The header
# changes, and one file recompiles, only when the commit does. Without git it says "unknown".
if(CMAKE_SCRIPT_MODE_FILE)
  set(commit unknown)
  if(GIT)
    # A copy unpacked inside another project's tree must not report that project's commit.
    execute_process(COMMAND "${GIT}" -C "${SOURCE}" ls-files --error-unmatch cmake/provenance.cmake
                    RESULT_VARIABLE untracked OUTPUT_QUIET ERROR_QUIET)
    if(untracked EQUAL 0)
      execute_process(COMMAND "${GIT}" -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=*
                      RESULT_VARIABLE failed OUTPUT_VARIABLE described ERROR_QUIET
                      OUTPUT_STRIP_TRAILING_WHITESPACE)
      if(failed EQUAL 0 AND described)
        set(commit "${described}")
      endif()
    endif()
  endif()
  set(text "#pragma once\n#define PF_COMMIT \"${commit}\"\n")
  set(before "")
  if(EXISTS "${HEADER}")
    file(READ "${HEADER}" before)
  endif()
  if(NOT before STREQUAL text)
    file(WRITE "${HEADER}" "${text}")
  endif()
  return()
endif()

find_program(PF_GIT git)
add_custom_target(pf_commit
  COMMAND ${CMAKE_COMMAND} "-DGIT=$<$<BOOL:${PF_GIT}>:${PF_GIT}>" "-DSOURCE=${PROJECT_SOURCE_DIR}"
          "-DHEADER=${PROJECT_BINARY_DIR}/generated/commit.hpp" -P "${CMAKE_CURRENT_LIST_FILE}"
  BYPRODUCTS "${PROJECT_BINARY_DIR}/generated/commit.hpp"
  COMMENT "" VERBATIM)
add_dependencies(pf_io pf_commit)
target_include_directories(pf_io PRIVATE "${PROJECT_BINARY_DIR}/generated")
