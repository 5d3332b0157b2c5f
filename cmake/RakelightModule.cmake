# How a module is made. One call a module:
#
#   rl_add_module(NAME geometry
#     SOURCES weld.cpp ...          relative to the module's folder
#     ISA_SOURCES kernel.cpp ...    compiled once per instruction set (docs/untrusted-files.md: the same bits)
#     DEPENDS math base             modules below it
#     EXTERNAL TBB::tbb             libraries of this module alone, never in include/
#     TESTS weld_test.cpp ...)      in tests/unit/<name>/
#
# It makes the static library rakelight_<name> (alias rakelight::<name>) and the test program test_<name>. These libraries are
# for tests; RakelightPackage.cmake puts their objects together as the one that is installed.

include(RakelightUnits)

# The faster linker for builds with tests: some thirty programs.
if(RAKELIGHT_TESTS AND NOT RAKELIGHT_LTO)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=gold RL_HAS_GOLD)
  if(RL_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
endif()

# Flags of every C++ source. Bits must not depend on the machine: no contraction, no fast-math; sqrt without errno.
add_library(rl_flags INTERFACE)
target_compile_features(rl_flags INTERFACE cxx_std_20)
target_compile_options(rl_flags INTERFACE -Wall -Wextra $<IF:$<CXX_COMPILER_ID:GNU>,-Wshadow=local,-Wshadow> -Wno-missing-field-initializers
  -ffp-contract=off -fno-math-errno -fno-strict-aliasing
  # Only what has RL_API (include/rakelight/base/export.h) is seen outside of a shared library, and nobody puts another in its place.
  -fvisibility=hidden -fvisibility-inlines-hidden $<$<NOT:$<BOOL:${EMSCRIPTEN}>>:-fno-semantic-interposition>)
if(EMSCRIPTEN)  # units of several sources shadow each other's names
  target_compile_options(rl_flags INTERFACE -fwasm-exceptions -Wno-shadow -Wno-deprecated-declarations
    "SHELL:-include ${PROJECT_SOURCE_DIR}/web/no_threads.h")
  target_link_options(rl_flags INTERFACE -fwasm-exceptions)
endif()
if(RAKELIGHT_WERROR)
  target_compile_options(rl_flags INTERFACE -Werror)
endif()
if(RAKELIGHT_SANITIZE)
  target_compile_options(rl_flags INTERFACE -fsanitize=${RAKELIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC says false things of instrumented code: std::regex
  target_link_options(rl_flags INTERFACE -fsanitize=${RAKELIGHT_SANITIZE})
endif()
if(RAKELIGHT_LTO)  # archives hold machine code too; what is compiled per instruction set stays as it is
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    message(FATAL_ERROR "RAKELIGHT_LTO needs GCC: archives would hold no machine code")
  endif()
  target_compile_options(rl_flags INTERFACE -flto=auto -ffat-lto-objects)
  target_link_options(rl_flags INTERFACE -flto=auto)
endif()
if(RAKELIGHT_FUZZ)
  target_compile_options(rl_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
target_compile_definitions(rl_flags INTERFACE RL_THREADS=$<BOOL:${RAKELIGHT_THREADS}> RL_PROCESSES=$<BOOL:${RAKELIGHT_PROCESSES}>)
target_compile_definitions(rl_flags INTERFACE $<$<OR:$<CONFIG:Debug>,$<BOOL:${RAKELIGHT_TESTS}>>:RL_ASSERTIONS=1>)
set_property(TARGET rl_flags PROPERTY INTERFACE_POSITION_INDEPENDENT_CODE ON)

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(RL_ISAS scalar sse2 avx2 avx512)
elseif(EMSCRIPTEN)  # every engine has its vectors of 128 bits, which it makes of SSE2's intrinsics
  set(RL_ISAS sse2)
else()  # the same bits, one pixel at a time; char is signed as there
  set(RL_ISAS scalar)
  target_compile_options(rl_flags INTERFACE -fsigned-char)
endif()
set(RL_ISA_FLAGS_scalar "")
set(RL_ISA_FLAGS_sse2 "-msse2")
if(EMSCRIPTEN)
  set(RL_ISA_FLAGS_sse2 "-msimd128;-msse2;-O2")  # what is hot; all else is compiled for its size
endif()
set(RL_ISA_FLAGS_avx2 "-mavx2;-mno-fma")
set(RL_ISA_FLAGS_avx512 "-mavx512f;-mavx512bw;-mavx512dq;-mavx512vl;-mavx512cd;-mprefer-vector-width=512")

# rl_add_objects(TARGET OBJECTS): objects compiled per instruction set become part of a target.
function(rl_add_objects target objects)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
  set_property(TARGET ${target} APPEND PROPERTY RL_OBJECTS ${objects})
  set_property(GLOBAL APPEND PROPERTY RL_ISA_OBJECTS ${objects})
endfunction()

# rl_add_flavour(TARGET ISA FLAVOUR DEFINITIONS SOURCES): objects for one set, whose symbols carry the flavour's name.
function(rl_add_flavour target isa flavour definitions)
  set(objects ${target}_${flavour})
  if(TARGET ${objects})
    set(objects ${target}_paired_${flavour})
  endif()
  add_library(${objects} OBJECT ${ARGN})
  target_link_libraries(${objects} PRIVATE rl_flags)
  target_include_directories(${objects} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(${objects} PRIVATE RL_ISA=${flavour} RL_ISA_${isa}=1 xsimd=xsimd_${flavour} ${definitions})
  target_compile_options(${objects} PRIVATE -O3 -fno-exceptions $<$<BOOL:${RAKELIGHT_LTO}>:-fno-lto> ${RL_ISA_FLAGS_${isa}}
    $<$<CXX_COMPILER_ID:GNU>:-fschedule-insns;-fsched-pressure>)
  rl_add_objects(${target} ${objects})
endfunction()

function(rl_add_isa_sources target)
  foreach(isa IN LISTS RL_ISAS)
    rl_add_flavour(${target} ${isa} ${isa} "" ${ARGN})
  endforeach()
endfunction()

# By pairs of vectors (math/wide_pair.h), for the set that has the registers for it.
function(rl_add_pair_sources target)
  if(avx512 IN_LIST RL_ISAS)
    rl_add_flavour(${target} avx512 avx512x2 RL_WIDE_PAIRS=1 ${ARGN})
  endif()
endfunction()

# As rl_add_isa_sources, with pairs in place of single vectors where there are any.
function(rl_add_paired_sources target)
  foreach(isa IN LISTS RL_ISAS)
    if(NOT isa STREQUAL avx512)
      rl_add_flavour(${target} ${isa} ${isa} "" ${ARGN})
    endif()
  endforeach()
  rl_add_pair_sources(${target} ${ARGN})
endfunction()

function(rl_add_module)
  cmake_parse_arguments(M "" "NAME" "SOURCES;ISA_SOURCES;PAIRED_SOURCES;DEPENDS;EXTERNAL;TESTS;TEST_EXTERNAL" ${ARGN})
  set(target rakelight_${M_NAME})
  if(M_SOURCES OR M_ISA_SOURCES)
    add_library(${target} STATIC ${M_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE ${M_EXTERNAL})
    set_property(GLOBAL APPEND PROPERTY RL_MODULES ${target})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(rakelight::${M_NAME} ALIAS ${target})
  target_link_libraries(${target} ${scope} $<BUILD_INTERFACE:rl_flags>)
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
  if(M_SOURCES)
    rl_units(${target})
  endif()
  foreach(below IN LISTS M_DEPENDS)
    target_link_libraries(${target} ${scope} rakelight_${below})
  endforeach()
  if(M_ISA_SOURCES)
    rl_add_isa_sources(${target} ${M_ISA_SOURCES})
  endif()
  if(M_PAIRED_SOURCES)
    rl_add_paired_sources(${target} ${M_PAIRED_SOURCES})
  endif()
  if(RAKELIGHT_TESTS AND M_TESTS)
    list(TRANSFORM M_TESTS PREPEND ${PROJECT_SOURCE_DIR}/tests/unit/${M_NAME}/)
    add_executable(test_${M_NAME} ${M_TESTS})
    target_link_libraries(test_${M_NAME} PRIVATE ${target} rl_test_support GTest::gtest GTest::gtest_main ${M_TEST_EXTERNAL})
    target_include_directories(test_${M_NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    rl_test_units(test_${M_NAME})
    gtest_discover_tests(test_${M_NAME} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 PROPERTIES LABELS unit)
  endif()
endfunction()
