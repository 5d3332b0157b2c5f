# Every build checks the symbols of the modules and of the objects per instruction set (tools/check/check_symbols.py): a call of
# libm's sin or a weak symbol without its flavour would make pictures depend on the processor. io is exempt: it makes no bits.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_Interpreter_FOUND)
  message(WARNING "No Python 3: the symbols of the libraries are not checked")
  return()
endif()

get_property(modules GLOBAL PROPERTY RL_MODULES)
get_property(isa_objects GLOBAL PROPERTY RL_ISA_OBJECTS)
list(REMOVE_ITEM modules rakelight_io)

set(lines "")
set(files "")
foreach(module IN LISTS modules)
  string(APPEND lines "module $<TARGET_FILE:${module}>\n")
  list(APPEND files $<TARGET_FILE:${module}>)
endforeach()
foreach(objects IN LISTS isa_objects)
  string(REGEX REPLACE ".*_" "" flavour ${objects})
  string(APPEND lines "isa ${flavour} $<JOIN:$<TARGET_OBJECTS:${objects}>,\nisa ${flavour} >\n")
  list(APPEND files $<TARGET_OBJECTS:${objects}>)
endforeach()
set(symbol_list ${PROJECT_BINARY_DIR}/symbol_check.txt)
file(GENERATE OUTPUT ${symbol_list} CONTENT "${lines}")

set(symbol_check Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check/check_symbols.py --nm ${CMAKE_NM} ${symbol_list})
add_custom_command(OUTPUT symbol_check.stamp
  COMMAND ${symbol_check}
  COMMAND ${CMAKE_COMMAND} -E touch symbol_check.stamp
  DEPENDS ${modules} ${isa_objects} ${files} ${symbol_list} ${PROJECT_SOURCE_DIR}/tools/check/check_symbols.py
  COMMENT "Checking symbols" VERBATIM)
add_custom_target(rakelight_check_symbols ALL DEPENDS symbol_check.stamp)

if(RAKELIGHT_TESTS)
  add_test(NAME symbols COMMAND ${symbol_check})
  add_test(NAME symbol_check_finds_faults
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/unit/math/check_symbols_test.py ${PROJECT_SOURCE_DIR}/tools/check)
  set_tests_properties(symbols symbol_check_finds_faults PROPERTIES LABELS unit)
endif()
