# Four functions, so that a folder's CMakeLists.txt is a list of facts and nothing else.
#
#   g31_library(g31_fanuc SOURCES compare.cc system_variables.cc DEPENDS g31_runtime)
#   g31_module(g31_step OF g31_part_import SOURCES import/step_module.cc DEPENDS open_cascade)
#   g31_test(NAME fanuc_test SOURCES ... DEPENDS g31_fanuc)
#   g31_bench(NAME g31_bench SOURCES ... DEPENDS g31_fanuc)

add_library(g31_warnings INTERFACE)
target_compile_options(g31_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough -Wswitch-enum
  # g++ 12 sees overlapping copies in any "text" + std::string (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # One rounding per operation on every compiler: results must not depend on fused multiply-add.
  -ffp-contract=off
  # Nobody asks errno or the processor's flags what a square root or a division has come to: without them the same
  # numbers come with fewer branches, straight moves in 0.98 of the time.
  -fno-math-errno -fno-trapping-math
  # At -O3 g++ 12 takes copies of texts and moves of variants for overflows and for use before a value;
  # the preset dev has these warnings.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-stringop-overflow;-Wno-array-bounds;-Wno-maybe-uninitialized>
  $<$<BOOL:${G31_WERROR}>:-Werror>)

# g++ looks for memory to free again and again from 128 MB on, in vain: a batch of files ends before much of it is
# free.  Without the search it takes a sixth less time, and 1.3 GB in place of 1.1 at most.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000>)

# Told to tests, too, which are not compiled with them: runs last ten times as long.
if(CMAKE_CXX_FLAGS MATCHES "sanitize")
  target_compile_definitions(g31_warnings INTERFACE G31_UNDER_SANITIZERS)
  # Under the address sanitizer Eigen would align by itself, and code of tests, which is not compiled with it, would free
  # what it took; its malloc aligns as that of every other build does.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()

# Release libraries that blocks go through one after the other (ACROSS_FILES: reading Fanuc blocks, what is made of a
# block when it runs, and the machine) are compiled as far as the linker needs to go on: g31 and the benchmarks are
# optimised across these files (plain blocks run a tenth faster).  The tests are linked file by file, in no time: for
# them the code of each such library is made when the first of them is built.  What runs once a run (G31_RUNS_ONCE in a
# folder's CMakeLists.txt: reading sheets, writing documents) is compiled quickly instead, which -Og does sooner than -O1
# by a seventh, and than -O0, under which nothing is inlined and all of it has to be written.
set(g31_links_across_files FALSE)
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND
   CMAKE_CXX_COMPILER_AR AND CMAKE_CXX_COMPILER_RANLIB)
  set(g31_links_across_files TRUE)
  set(CMAKE_AR ${CMAKE_CXX_COMPILER_AR})  # these read such code
  set(CMAKE_RANLIB ${CMAKE_CXX_COMPILER_RANLIB})
endif()

function(g31_compile_quickly name)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${name} PRIVATE -Og)
  endif()
endfunction()

function(g31_link_across_files name)
  if(g31_links_across_files)
    target_compile_options(${name} PRIVATE -flto=auto)
    # In two pieces, side by side: 31 s in the place of 56.  Where the linker divides the code costs or gains lines a
    # twentieth, by chance.
    target_link_options(${name} PRIVATE -flto=auto -flto-partition=balanced --param=lto-partitions=2)
  endif()
endfunction()

function(g31_link_file_by_file name)
  set_target_properties(${name} PROPERTIES G31_FILE_BY_FILE TRUE)
  if(g31_links_across_files)
    target_link_options(${name} PRIVATE -fno-lto)
  endif()
endfunction()

# A library without files of its own; behind its name what it stands for.
function(g31_interface name)
  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE ${ARGN})
  target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
  target_compile_features(${name} INTERFACE cxx_std_20)
endfunction()

# A library that a program takes as code for the linker to go on with (CODE), or, linked file by file, as what is made
# of that here.
function(g31_library_of_two_codes name)
  cmake_parse_arguments(arg "" "CODE" "DEPENDS" ${ARGN})
  set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}_by_file.o)
  set(archive ${CMAKE_CURRENT_BINARY_DIR}/lib${name}_by_file.a)
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}")
  add_custom_command(OUTPUT ${archive}
    COMMAND ${CMAKE_CXX_COMPILER} ${flags} -r -nostdlib -flto=1 -flto-partition=none -flinker-output=nolto-rel
      "$<TARGET_OBJECTS:${arg_CODE}>" -o ${object}
    COMMAND ${CMAKE_COMMAND} -E rm -f ${archive}
    COMMAND ${CMAKE_AR} qcs ${archive} ${object}
    DEPENDS "$<TARGET_OBJECTS:${arg_CODE}>"
    BYPRODUCTS ${object}
    COMMENT "Making code of ${name} for programs linked file by file"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(${name}_make_by_file DEPENDS ${archive})
  add_library(${name}_by_file STATIC IMPORTED GLOBAL)
  set_target_properties(${name}_by_file PROPERTIES IMPORTED_LOCATION ${archive})
  target_link_libraries(${name}_by_file INTERFACE ${arg_DEPENDS})
  add_dependencies(${name}_by_file ${name}_make_by_file)
  g31_interface(${name} $<IF:$<BOOL:$<TARGET_PROPERTY:G31_FILE_BY_FILE>>,${name}_by_file,${arg_CODE}>)
endfunction()

# What nearly every file includes is compiled once, and once more for the tests.  A file includes what it
# needs all the same: the preset tidy builds without, and tells.
option(G31_PRECOMPILED_HEADERS "Compile the standard library's, Eigen's, fmt's and GTest's headers once" ON)
set(g31_prelude
  <algorithm> <array> <charconv> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <numbers> <optional> <set> <span> <string> <string_view> <unordered_map> <utility> <variant> <vector>
  <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)
# What runs once a run writes documents.
set(g31_quick_prelude ${g31_prelude} <nlohmann/json.hpp>)
set(g31_test_prelude <gtest/gtest.h> ${g31_quick_prelude})

# A library is compiled many files at a time: templates that they share are made less often.  Forty take less time than
# twenty, and 2.4 GB at most, those of tests.  The files of a batch share one anonymous namespace.
option(G31_BATCHES "Compile libraries and tests several files at a time" ON)
set(g31_batch 40)

function(g31_compile_in_batches name)
  if(G31_BATCHES)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${g31_batch})
  endif()
endfunction()

function(g31_library name)
  cmake_parse_arguments(arg "ACROSS_FILES" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  if(NOT arg_SOURCES)
    g31_interface(${name} ${arg_DEPENDS})
    return()
  endif()
  set(code ${name})
  if(g31_links_across_files AND arg_ACROSS_FILES)
    set(code ${name}_across_files)
    g31_library_of_two_codes(${name} CODE ${code} DEPENDS ${arg_DEPENDS} ${arg_PRIVATE_DEPENDS})
  endif()
  add_library(${code} STATIC ${arg_SOURCES})
  target_link_libraries(${code} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS} g31_warnings)
  target_include_directories(${code} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_features(${code} PUBLIC cxx_std_20)
  if(G31_RUNS_ONCE)
    g31_compile_quickly(${code})
    g31_take_prelude(${code} g31_quick_prelude quick)
  else()
    if(NOT code STREQUAL name)
      target_compile_options(${code} PRIVATE -flto=auto)
    endif()
    g31_take_prelude(${code} g31_prelude fast)
  endif()
  g31_compile_in_batches(${code})
endfunction()

# A part of the library OF that is loaded when a run first needs it (machine/base/module.h).
function(g31_module name)
  cmake_parse_arguments(arg "" "OF" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name} MODULE ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${G31_MODULES}
    BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "")  # that of the program holds
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_features(${name} PRIVATE cxx_std_20)
  g31_compile_quickly(${name})
  g31_compile_in_batches(${name})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} g31_warnings)
  # Whoever links the library finds the module beside it.
  add_dependencies(${arg_OF} ${name})
  set_property(GLOBAL APPEND PROPERTY g31_module_targets ${name})
endfunction()

# The first target that is compiled in one way (quick or fast) makes a prelude, the others take what it made.
function(g31_take_prelude name prelude way)
  if(NOT G31_PRECOMPILED_HEADERS)
    return()
  endif()
  # All must agree on the macros that these headers look at.
  target_link_libraries(${name} PRIVATE fmt::fmt Eigen3::Eigen)
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    set(way alike)
  endif()
  get_property(maker GLOBAL PROPERTY ${prelude}_${way})
  if(maker)
    target_precompile_headers(${name} REUSE_FROM ${maker})
  else()
    set_property(GLOBAL PROPERTY ${prelude}_${way} ${name})
    target_precompile_headers(${name} PRIVATE ${${prelude}})
  endif()
endfunction()

# Eigen without optimisation is so slow that a debug build would be of no use for whole runs.
function(g31_always_optimise name)
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(${name} PRIVATE -O2)
    set_target_properties(${name} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# Code of tests is the same in every build, whatever it is linked to: a build can take that of another, which is made
# before, instead of compiling it once more (-D G31_TEST_CODE_OF=build/release).
set(G31_TEST_CODE_OF "" CACHE PATH "Another build, whose code of the tests is linked")

# The program's own libraries are checked by the sanitizers, the code of their tests is not, and stack traces name no
# lines of it: it takes half the time to compile.  Libraries of tests (tests/support) are checked.
function(g31_compile_test_code name)
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(${name} PRIVATE -Og -g0 -fno-omit-frame-pointer -fno-sanitize=all)
    target_compile_definitions(${name} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
  g31_take_prelude(${name} g31_test_prelude quick)
  # The names of a test file are in a namespace of its own, so that a batch of them compiles as one.
  g31_compile_in_batches(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/test_code/${name}.txt
    CONTENT "$<JOIN:$<TARGET_OBJECTS:${name}>,\n>\n")
endfunction()

function(g31_take_test_code name)
  get_filename_component(folder "${G31_TEST_CODE_OF}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  set(list ${folder}/test_code/${name}.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} code)
  add_executable(${name} ${code})
  set_source_files_properties(${code} PROPERTIES EXTERNAL_OBJECT TRUE)
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
endfunction()

function(g31_test)
  cmake_parse_arguments(arg "" "NAME;PREFIX;COST" "SOURCES;DEPENDS" ${ARGN})
  if(G31_TEST_CODE_OF)
    g31_take_test_code(${arg_NAME})
  else()
    add_executable(${arg_NAME} ${arg_SOURCES})
    g31_compile_test_code(${arg_NAME})
  endif()
  target_link_libraries(${arg_NAME} PRIVATE ${arg_DEPENDS} g31_warnings GTest::gtest_main)
  g31_link_file_by_file(${arg_NAME})
  if(CMAKE_CXX_FLAGS MATCHES "sanitize")
    list(LENGTH arg_SOURCES files)
    g31_run_in_shares(${arg_NAME} ${files} "${arg_PREFIX}" "${arg_COST}")
    return()
  endif()
  # Tests run in the source folder: golden files and parts are named by their repository path.
  # They are listed when ctest starts, not while the build keeps every core busy.
  gtest_discover_tests(${arg_NAME} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    TEST_PREFIX "${arg_PREFIX}"
    PROPERTIES FIXTURES_REQUIRED documents_of_tests
    DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120)
endfunction()

# A program under the address sanitizer takes a third of a second to begin and end, most tests a hundredth: so
# there a process runs a share of a program's tests, not one.  What became of each is in a file of its own.
function(g31_run_in_shares name files prefix cost)
  math(EXPR shares "(${files} + 9) / 10")
  if(NOT cost)
    set(cost ${files})
  endif()
  foreach(share RANGE 1 ${shares})
    math(EXPR index "${share} - 1")
    set(test ${prefix}${name}.${share}_of_${shares})
    add_test(NAME ${test} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${test} PROPERTIES
      COST ${cost}
      FIXTURES_REQUIRED documents_of_tests
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${shares};GTEST_SHARD_INDEX=${index};GTEST_OUTPUT=xml:${PROJECT_BINARY_DIR}/results/${test}.xml")
  endforeach()
endfunction()

# One program of Google Benchmark cases; never run by ctest: times are for reading, not for failing.  It is built on
# request, `cmake --build --preset release --target g31_bench`: a minute that no test needs.
function(g31_bench)
  cmake_parse_arguments(arg "" "NAME" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${arg_NAME} EXCLUDE_FROM_ALL ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE ${arg_DEPENDS} g31_warnings benchmark::benchmark_main)
  g31_link_across_files(${arg_NAME})
  target_include_directories(${arg_NAME} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
