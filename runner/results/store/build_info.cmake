# Writes build_info.cpp. Included by runner/CMakeLists.txt, after the module `results`; run as a script by
# that target at every build, where it rewrites the file only if something in it has changed. So a commit costs one small
# file and the link, nothing else is rebuilt, and no edit can hide from the build's identity.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  # What the build system knows, fixed when it is configured.
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_target_property(rules morula_flags INTERFACE_COMPILE_OPTIONS)
  string(GENEX_STRIP "${rules}" rules)
  string(JOIN " " flags ${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${rules})
  pkg_check_modules(XXHASH QUIET libxxhash)
  set(libraries "")
  set(tbb "oneTBB=${TBB_VERSION}")
  if(NOT MORULA_THREADS STREQUAL ON)
    unset(tbb)
  endif()
  foreach(library IN ITEMS "Bullet=${BULLET_VERSION}" "CLI11=${CLI11_VERSION}" "Eigen=${Eigen3_VERSION}"
          "OSMesa=${OSMESA_VERSION}" "SQLite=${SQLite3_VERSION}" "cairo=${CAIRO_cairo-pdf_VERSION}" "fmt=${fmt_VERSION}"
          "nlohmann_json=${nlohmann_json_VERSION}" ${tbb} "xxHash=${XXHASH_VERSION}"
          "yaml-cpp=${yaml-cpp_VERSION}")
    string(REPLACE "=" "\", \"" pair "${library}")
    string(REGEX REPLACE "\"$" "\"unknown" pair "${pair}")
    string(APPEND libraries "    {\"${pair}\"},\n")
  endforeach()
  set(BUILD_INFO_CPP ${CMAKE_CURRENT_BINARY_DIR}/build_info.cpp)
  set(facts ${CMAKE_CURRENT_BINARY_DIR}/build_facts.cmake)
  file(CONFIGURE OUTPUT ${facts} @ONLY CONTENT [==[
set(version [[@PROJECT_VERSION@]])
set(compiler [[@CMAKE_CXX_COMPILER_ID@ @CMAKE_CXX_COMPILER_VERSION@]])
set(flags [[@flags@]])
set(target [[@CMAKE_SYSTEM_NAME@ @CMAKE_SYSTEM_PROCESSOR@]])
set(libraries [[@libraries@]])
]==])
  add_custom_target(build_info
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${CMAKE_SOURCE_DIR} -DFACTS=${facts} -DOUTPUT=${BUILD_INFO_CPP}
            -P ${CMAKE_CURRENT_LIST_FILE}
    BYPRODUCTS ${BUILD_INFO_CPP} VERBATIM COMMENT "What this build is made from")
  set_source_files_properties(${BUILD_INFO_CPP} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # new with each commit
  target_sources(runner_results PRIVATE ${BUILD_INFO_CPP})
  add_dependencies(runner_results build_info)
  return()
endif()

cmake_minimum_required(VERSION 3.22)
include(${FACTS})

# The sources' digest: of their names and contents, in order of name.
file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/core/*.h ${SOURCE}/core/*.cpp ${SOURCE}/core/*.cmake
     ${SOURCE}/core/CMakeLists.txt ${SOURCE}/reports/*.h ${SOURCE}/reports/*.cpp ${SOURCE}/reports/CMakeLists.txt ${SOURCE}/runner/*.h ${SOURCE}/runner/*.cpp ${SOURCE}/runner/*.cmake ${SOURCE}/runner/CMakeLists.txt
     ${SOURCE}/CMakeLists.txt)
list(FILTER files INCLUDE REGEX "^(core/|reports/|runner/|CMakeLists.txt$)")
list(SORT files)
set(listing "")
foreach(file IN LISTS files)
  file(SHA256 ${SOURCE}/${file} digest)
  string(APPEND listing "${digest} ${file}\n")
endforeach()
string(SHA256 sources "${listing}")
string(SUBSTRING ${sources} 0 32 sources)

# The commit: unknown without git, in a source archive, or inside somebody else's repository.
function(git result)
  execute_process(COMMAND git -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE out RESULT_VARIABLE code ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(code EQUAL 0)
    set(${result} "${out}" PARENT_SCOPE)
  else()
    set(${result} "unknown" PARENT_SCOPE)
  endif()
endfunction()
set(commit unknown)
set(state unknown)
git(top rev-parse --show-toplevel)
file(REAL_PATH ${SOURCE} here)
if(top STREQUAL here)
  git(commit rev-parse HEAD)
  git(edited status --porcelain --untracked-files=no)
  git(added status --porcelain core reports runner CMakeLists.txt)  # a new source is an edit too
  if("${edited}${added}" STREQUAL "")
    set(state clean)
  elseif(NOT commit STREQUAL "unknown")
    set(state modified)
  endif()
endif()

# What was edited, for the record of runs. In hexadecimal: a diff may hold anything, this file's own brackets too.
set(diff "")
if(state STREQUAL "modified")
  set(limit 262144)
  set(edits ${OUTPUT}.diff)
  execute_process(COMMAND git -C ${SOURCE} diff --no-ext-diff --no-color HEAD OUTPUT_FILE ${edits} ERROR_QUIET)
  git(new -c core.quotepath=off ls-files --others --exclude-standard core reports runner CMakeLists.txt)
  string(REPLACE "\n" ";" new "${new}")
  foreach(file IN LISTS new)
    execute_process(COMMAND git -C ${SOURCE} diff --no-ext-diff --no-color --no-index -- /dev/null ${file}
                    OUTPUT_FILE ${edits}.new ERROR_QUIET)
    execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${edits} ${edits}.new OUTPUT_FILE ${edits}.both)
    file(RENAME ${edits}.both ${edits})
  endforeach()
  file(SIZE ${edits} size)
  file(READ ${edits} diff LIMIT ${limit} HEX)
  if(size GREATER limit)
    string(HEX "\n(cut: ${limit} of ${size} bytes)\n" cut)
    string(APPEND diff ${cut})
  endif()
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," diff "${diff}")
endif()

file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [==[// Written by runner/results/store/build_info.cmake at each build.
#include "store/build_info.h"

namespace morula {

const BuildInfo& buildInfo() {
  static const BuildInfo info{R"(@version@)", "@sources@", "@commit@", "@state@", R"(@compiler@)", R"(@flags@)",
                              R"(@target@)", {
@libraries@  }};
  return info;
}

const std::string& buildDiff() {
  static const std::string diff{@diff@};
  return diff;
}

}  // namespace morula
]==])
