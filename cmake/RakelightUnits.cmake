# rl_units(TARGET): compiles the target's sources some at a time, which takes a third of the time of each by itself. cmake/units.py says which
# may go together. RAKELIGHT_UNITS is the most sources of a unit: a changed source compiles its unit again. 0: each by itself, as clang-tidy
# wants it; also without Python. Sources with the property SKIP_UNITY_BUILD_INCLUSION stay by themselves, too.
# rl_test_units(TARGET): the same for a test program, half as many: tests are longer. They share the compiled headers of rl_test_headers.
set(RAKELIGHT_UNITS 8 CACHE STRING "Most sources that are compiled as one; 0: each by itself")
if(NOT RAKELIGHT_UNITS)
  set(RAKELIGHT_UNITS 0)  # OFF and the like
endif()
find_package(Python3 QUIET COMPONENTS Interpreter)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS cmake/units.py)

function(rl_units target)
  rl_units_later(${target} "${RAKELIGHT_UNITS}")
endfunction()

# A third less time to compile than -O2. Some get -pthread from libraries, and all share headers, so all have it. A fixture of an unnamed
# namespace and its tests outside of it stay in the one source, which a unit includes.
set(RL_TEST_OPTIONS $<$<CONFIG:Release>:-O1> -pthread -Wno-subobject-linkage)

function(rl_test_units target)
  math(EXPR most "${RAKELIGHT_UNITS} / 2")
  rl_units_later(${target} ${most})
  target_compile_options(${target} PRIVATE ${RL_TEST_OPTIONS})
  if(RAKELIGHT_UNITS)
    target_precompile_headers(${target} REUSE_FROM rl_test_headers)
  endif()
endfunction()

# When the folder has named all of the target's sources.
function(rl_units_later target most)
  cmake_language(EVAL CODE "cmake_language(DEFER CALL rl_units_of ${target} ${most})")
endfunction()

function(rl_units_of target most)
  if(NOT most OR NOT Python3_Interpreter_FOUND)
    return()
  endif()
  get_target_property(all ${target} SOURCES)
  get_target_property(from ${target} SOURCE_DIR)
  set(sources "")
  foreach(source IN LISTS all)
    get_source_file_property(definitions ${source} COMPILE_DEFINITIONS)
    get_source_file_property(is_alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${from})
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} is_made)
    if(source MATCHES "\\.cpp$" AND NOT is_made AND NOT definitions AND NOT is_alone)
      list(APPEND sources ${source})
    endif()
  endforeach()
  execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/units.py ${most} ${sources}
    OUTPUT_VARIABLE units OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" units "${units}")
  foreach(line IN LISTS units)
    string(REGEX MATCH "^(.*),([0-9]+)$" matched "${line}")
    set_source_files_properties(${CMAKE_MATCH_1} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_2})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
